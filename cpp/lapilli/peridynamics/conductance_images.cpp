#include <algorithm>
#include <cmath>

#include "lapilli/peridynamics/conductances.hpp"

// What adiabatic walls take from the bonds of a point, and what their mirrors add.

namespace lapilli {

template <int Dim>
void Conductances<Dim>::find_images(Index task) {
  if (!corrected_) {
    return;
  }
  std::vector<Image>& found = images_[static_cast<std::size_t>(task)];
  found.clear();
  for (Index i = task * conductance_piece;
       i < std::min(points_.size(), (task + 1) * conductance_piece); ++i) {
    image_begin_[static_cast<std::size_t>(i)] = static_cast<Index>(found.size());
    if (families_.owns(i) && insulation_.near(i)) {
      insulation_.images(i, weight_.horizon, found);
    }
  }
}

template <int Dim>
std::span<const typename Insulation<Dim>::Image> Conductances<Dim>::images(Index point) const {
  const auto& found = images_[static_cast<std::size_t>(point / conductance_piece)];
  const bool last = point + 1 == points_.size() || (point + 1) % conductance_piece == 0;
  const auto begin = static_cast<std::size_t>(image_begin_[static_cast<std::size_t>(point)]);
  const auto end =
      last ? found.size()
           : static_cast<std::size_t>(image_begin_[static_cast<std::size_t>(point) + 1]);
  return std::span(found).subspan(begin, end - begin);
}

template <int Dim>
void Conductances<Dim>::hide_bonds(Index i, Sums& sums) {
  const double* own = rows_.data() + i * Row::size;
  for (Index k = families_.wall_begin(i); k < families_.end(i); ++k) {
    const Index j = families_.neighbour(k);
    if (conductance_[k] == 0.0 || !insulation_.hides(i, j)) {
      continue;
    }
    const double* other = rows_.data() + j * Row::size;
    const double s = conductance_[k] / (0.5 * conductivity_ * own[Row::volume]);
    Vec<Dim> bond;
    double along = 0.0;
    for (int d = 0; d < Dim; ++d) {
      bond[d] = other[d] - own[d];
    }
    for (int a = 0; a < Dim; ++a) {
      for (int b = a; b < Dim; ++b) {
        const int at = Row::tensor(Row::entry(a, b));
        along += (a == b ? 1.0 : 2.0) * bond[a] * bond[b] * (own[at] + other[at]);
      }
    }
    const double squared = bond.squaredNorm();
    sums.add(bond, -s, -s * squared / along);
    conductance_[k] = 0.0;
  }
}

template <int Dim>
double Conductances<Dim>::image_weight(const Image& image, Index owner) const {
  const Index of = image.bond < 0 ? owner : families_.neighbour(image.bond);
  return weight_(std::sqrt(image.squared)) * rows_[of * Row::size + Row::volume];
}

template <int Dim>
void Conductances<Dim>::add_images(Index i, Sums& sums) {
  const double* own = rows_.data() + i * Row::size;
  for (const Image& image : images(i)) {
    const Index j = image.bond < 0 ? i : families_.neighbour(image.bond);
    const double w = image_weight(image, i);
    const double s = w * (Row::mean(own) + Row::mean(rows_.data() + j * Row::size));
    if (image.bond >= 0) {
      conductance_[image.bond] += 0.5 * conductivity_ * s * own[Row::volume];
    }
    sums.add(image.to, s, w);
  }
}

#define LAPILLI_INSTANTIATE(Dim)                             \
  template void Conductances<Dim>::find_images(Index);       \
  template void Conductances<Dim>::hide_bonds(Index, Sums&); \
  template void Conductances<Dim>::add_images(Index, Sums&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
