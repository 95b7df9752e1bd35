#include "lapilli/mpm/quasi_static/reference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

std::span<const double> numbers(const Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Index>(numbers.size()));
}

}  // namespace

template <int Dim>
Reference<Dim>::Reference(Points& points, bool gimp)
    : position(points, Dim),
      volume(points, 1),
      half_width(gimp ? std::make_unique<PointArray>(points, Dim) : nullptr) {}

template <int Dim>
void Reference<Dim>::start(const Points& points, const PointArray* now, double at) {
  std::copy_n(points.position().data(), points.position().size(), position.data());
  std::copy_n(points.volume().data(), points.volume().size(), volume.data());
  for (LoadedSurface<Dim>& surface : loaded) {
    surface.reset();
  }
  if (skin) {
    skin->reset();
  }
  if (half_width) {
    std::copy_n(now->data(), now->values().size(), half_width->data());
  }
  time = at;
  moved.resize(0);
  imbalance.resize(0);
}

template <int Dim>
void Reference<Dim>::locate(const Grid<Dim>& grid, const Points& points,
                            std::span<const LinearElastic> materials,
                            std::span<const char> averaged, const Boundary<Dim>& boundary) {
  located = factorised = false;
  const std::span<const double> places = std::as_const(position).values();
  const std::span<const double> volumes = std::as_const(volume).values();
  const std::span<const double> widths =
      half_width ? std::as_const(*half_width).values() : std::span<const double>();
  weights.build(grid, places, widths);
  state = std::make_unique<CellState<Dim>>(grid, volumes, points.body(), weights, materials);
  state->mean.build(grid, places, widths, volumes, points.body(), averaged, weights);
  facets = boundary.cut_walls(grid, *state, time);
  ends = softens_ends ? support_ends<Dim>(grid, boundary, facets, time) : std::vector<SupportEnd>();
  if (loaded.empty()) {
    loaded = boundary.cut_tractions(grid, *state);
  }
  for (LoadedSurface<Dim>& surface : loaded) {
    surface.find_cells(grid, *state);
  }
  find_skin(grid);
  located = true;
}

/// Without a cell for every place of it the skin is no use.
template <int Dim>
void Reference<Dim>::find_skin(const Grid<Dim>& grid) {
  if (!skin) {
    return;
  }
  try {
    skin->find_cells(grid, *state);
  } catch (const RunError&) {
    skin.reset();
  }
}

template <int Dim>
double Reference<Dim>::farthest(const Points& points, const std::vector<Vec<Dim>>& moves) const {
  double most = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    for (int axis = 0; axis < Dim; ++axis) {
      const Index k = Dim * p + axis;
      const double to = points.position()[k] + (moves.empty() ? 0.0 : moves[p][axis]);
      most = std::max(most, std::abs(to - position[k]));
    }
  }
  return most;
}

template <int Dim>
void Reference<Dim>::save(Archive& archive) const {
  archive.write("quasi_static/reference/time", time);
  archive.write("quasi_static/reference/pointwise", scheme.pointwise);
  archive.write("quasi_static/reference/stiff", scheme.stiff);
  archive.write("quasi_static/reference/moved", numbers(moved));
  archive.write("quasi_static/reference/imbalance", numbers(imbalance));
  archive.write("quasi_static/reference/imbalance_due", imbalance_due ? 1.0 : 0.0);
  archive.write("quasi_static/reference/position", position.values());
  archive.write("quasi_static/reference/volume", volume.values());
  for (std::size_t t = 0; t < loaded.size(); ++t) {
    loaded[t].save(archive, message("quasi_static/reference/traction ", t));
  }
  archive.write("quasi_static/reference/has_skin", skin ? 1.0 : 0.0);
  if (skin) {
    skin->save(archive, "quasi_static/reference/skin");
  }
  std::vector<double> forces;
  for (const Vec<Dim>& force : support_forces) {
    forces.insert(forces.end(), force.data(), force.data() + Dim);
  }
  archive.write("quasi_static/reference/support_forces", std::span<const double>(forces));
  if (half_width) {
    archive.write("quasi_static/reference/half_width", std::as_const(*half_width).values());
  }
}

template <int Dim>
void Reference<Dim>::load(const Archive& archive) {
  time = archive.read_number("quasi_static/reference/time");
  scheme.pointwise = archive.read_number("quasi_static/reference/pointwise");
  scheme.stiff = archive.read_number("quasi_static/reference/stiff");
  moved = vector_of(archive.read_numbers("quasi_static/reference/moved"));
  imbalance = vector_of(archive.read_numbers("quasi_static/reference/imbalance"));
  imbalance_due = archive.read_number("quasi_static/reference/imbalance_due") > 0.0;
  archive.read("quasi_static/reference/position", position.values());
  archive.read("quasi_static/reference/volume", volume.values());
  for (std::size_t t = 0; t < loaded.size(); ++t) {
    loaded[t].load(archive, message("quasi_static/reference/traction ", t));
  }
  if (archive.read_number("quasi_static/reference/has_skin") > 0.0) {
    skin.emplace("the surface of the bodies");
    skin->load(archive, "quasi_static/reference/skin");
  } else {
    skin.reset();
  }
  const std::vector<double> forces = archive.read_numbers("quasi_static/reference/support_forces");
  support_forces.resize(forces.size() / Dim);
  for (std::size_t w = 0; w < support_forces.size(); ++w) {
    support_forces[w] = Eigen::Map<const Vec<Dim>>(forces.data() + Dim * w);
  }
  if (half_width) {
    archive.read("quasi_static/reference/half_width", half_width->values());
  }
}

template struct Reference<2>;
template struct Reference<3>;

}  // namespace lapilli
