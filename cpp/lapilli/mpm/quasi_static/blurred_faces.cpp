#include "lapilli/mpm/quasi_static/blurred_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "lapilli/geometry/cell_box.hpp"

namespace lapilli {
namespace {

constexpr double stiffer = 1.5;  // times: bodies nearer than that strain alike

struct Strained {
  Mat3 strain = Mat3::Zero();  // times volume
  double volume = 0.0;         // m^Dim
  bool shared = false;         // with a stiffer body

  void add(const Strained& other) {
    strain += other.strain;
    volume += other.volume;
  }
};

Mat3 elastic_strain(const LinearElastic& material, const Mat3& stress) {
  const double nu = material.poissons_ratio;
  return ((1.0 + nu) * stress - nu * stress.trace() * Mat3::Identity()) / material.youngs_modulus;
}

}  // namespace

template <int Dim>
BlurredFace worst_blurred_face(const Grid<Dim>& grid, const Points& points,
                               const SolidState& solids) {
  const auto bodies = static_cast<Index>(solids.elastic().size());
  if (bodies < 2) {
    return {};
  }
  std::vector<std::map<Index, Strained>> cells(static_cast<std::size_t>(bodies));
  for (Index p = 0; p < points.size(); ++p) {
    const Index body = points.body()[p];
    const double volume = points.volume()[p];
    const Index cell = grid.cell_index(grid.cell_containing(points.position<Dim>(p)));
    const Mat3 strain = elastic_strain(solids.elastic(body), solids.stress(p).matrix());
    cells[body][cell].add({volume * strain, volume, false});
  }
  BlurredFace worst;
  for (Index body = 0; body < bodies; ++body) {
    const double own = solids.elastic(body).wave_modulus();
    for (Index other = 0; other < bodies; ++other) {
      if (solids.elastic(other).wave_modulus() <= stiffer * own) {
        continue;
      }
      for (auto& [cell, one] : cells[body]) {
        one.shared = one.shared || cells[other].contains(cell);
      }
    }
    double squared = 0.0, faces = 0.0;
    for (const auto& [cell, one] : cells[body]) {
      if (!one.shared) {
        continue;
      }
      Strained beside;
      CellBox<Dim> around{grid.cell_at(cell), {}};
      for (int axis = 0; axis < Dim; ++axis) {
        around.first[axis] -= 1;
      }
      around.cells.fill(3);
      for_each_cell(grid, around, [&](Index next) {
        const auto found = cells[body].find(next);
        if (found != cells[body].end() && !found->second.shared) {
          beside.add(found->second);
        }
      });
      if (beside.volume > 0.0) {
        const Mat3 lost = beside.strain / beside.volume - one.strain / one.volume;
        const double missing = lost.norm() * one.volume / std::pow(grid.cell_size(), Dim - 1);
        squared += missing * missing;
        faces += 1.0;
      }
    }
    const double missing = faces > 0.0 ? std::sqrt(squared / faces) : 0.0;
    if (missing > worst.missing) {
      worst = {body, missing};
    }
  }
  return worst;
}

template BlurredFace worst_blurred_face<2>(const Grid<2>&, const Points&, const SolidState&);
template BlurredFace worst_blurred_face<3>(const Grid<3>&, const Points&, const SolidState&);

}  // namespace lapilli
