#include "lapilli/peridynamics/stress_force.hpp"

#include "lapilli/peridynamics/lanes.hpp"

namespace lapilli {

using lanes::multiply_add;

template <int Dim>
StressForce<Dim>::StressForce(Index points)
    : rows_(static_cast<std::size_t>(points * row_size), 0.0),
      force_(static_cast<std::size_t>(points), Vec<Dim>::Zero()),
      bonds_(static_cast<std::size_t>(points), Vec<Dim>::Zero()) {}

template <int Dim>
void StressForce<Dim>::set(Index point, const Mat<Dim>& stress, const double* position,
                           const Vec<Dim>& viscous, const Vec<Dim>& bonds) {
  force_[static_cast<std::size_t>(point)] = viscous;
  bonds_[static_cast<std::size_t>(point)] = bonds;
  double* row = rows_.data() + point * row_size;
  if constexpr (Dim == 3) {
    for (int d = 0; d < 3; ++d) {
      Eigen::Map<Vec<3>>(row + 4 * d) = stress.col(d);
      row[12 + d] = position[d];
    }
  } else {
    for (int d = 0; d < Dim; ++d) {
      row[2 * d] = stress(0, d);
      row[2 * d + 1] = Dim == 2 ? stress(Dim - 1, d) : 0.0;
      row[4 + 2 * d] = row[5 + 2 * d] = position[d];
    }
  }
}

template <int Dim>
Vec<Dim> StressForce<Dim>::operator()(Index point, const Families& families,
                                      const double* bond_weight) const {
  const std::int32_t* neighbours = families.neighbours() + families.begin(point);
  const Index end = families.end(point) - families.begin(point);
  const Index padded_end = families.padded_end(point) - families.begin(point);
  const double* own = rows_.data() + point * row_size;
  const Vec<Dim>& bonds = bonds_[static_cast<std::size_t>(point)];
  Vec<Dim> force = force_[static_cast<std::size_t>(point)];
  if constexpr (Dim == 3) {
    const Double4 x = load_quad(own + 12);
    Double4 sum = all(0.0);
    for (Index k = 0; k < end; ++k) {
      const double* other = rows_.data() + neighbours[k] * row_size;
      const Double4 bond = (load_quad(other + 12) - x) * all(bond_weight[k]);
      for (int d = 0; d < 3; ++d) {
        sum = multiply_add(load_quad(other + 4 * d), all(bond[d]), sum);
      }
    }
    for (int d = 0; d < 3; ++d) {
      force[d] += sum[d];
      force += bonds[d] * Eigen::Map<const Vec<3>>(own + 4 * d);
    }
  } else {
    const Double4 x = load_quad(own + 4);
    Double4 even = all(0.0), odd = even;
    for (Index k = 0; k < padded_end; k += 2) {
      const double* first = rows_.data() + neighbours[k] * row_size;
      const double* second = rows_.data() + neighbours[k + 1] * row_size;
      even = multiply_add(load_quad(first), (load_quad(first + 4) - x) * all(bond_weight[k]), even);
      odd = multiply_add(load_quad(second), (load_quad(second + 4) - x) * all(bond_weight[k + 1]),
                         odd);
    }
    even += odd;
    for (int d = 0; d < Dim; ++d) {
      force[d] += even[d] + even[2 + d];
      for (int e = 0; e < Dim; ++e) {
        force[e] += bonds[d] * own[2 * d + e];
      }
    }
  }
  return force;
}

template class StressForce<1>;
template class StressForce<2>;
template class StressForce<3>;

}  // namespace lapilli
