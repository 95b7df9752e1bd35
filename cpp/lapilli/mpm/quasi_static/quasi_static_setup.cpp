#include <algorithm>
#include <cmath>
#include <utility>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/quasi_static/on_bodies.hpp"
#include "lapilli/mpm/quasi_static/quasi_static.hpp"
#include "lapilli/mpm/surface/narrow_gap.hpp"

namespace lapilli {

template <int Dim>
QuasiStatic<Dim>::QuasiStatic(Points& points, const Grid<Dim>& grid, ShapeFunction shape_function,
                              const std::vector<Solid>& materials, QuasiStaticSettings settings,
                              std::vector<Shape> shapes, const std::vector<char>& in_cells)
    : points_(points),
      grid_(grid),
      settings_(std::move(settings)),
      steps_(settings_),
      boundary_(settings_, std::move(shapes)),
      solids_(points, materials),
      start_volume_(points, 1),
      displacement_(points, Dim),
      guarded_(points, static_cast<int>(std::max<std::size_t>(1, boundary_.walls()))),
      support_forces_(boundary_.walls(), Vec<Dim>::Zero()),
      reference_(points, shape_function == ShapeFunction::gimp) {
  require(points.dimension() == Dim && points.size() > 0, "quasi_static needs points of dimension ",
          Dim);
  require(shape_function != ShapeFunction::bspline,
          "quasi_static takes grid.shape_function linear or gimp, not bspline");
  std::copy_n(points.volume().data(), points.volume().size(), start_volume_.data());
  choose_schemes();
  if (shape_function == ShapeFunction::gimp) {
    start_half_widths(in_cells);
  }
  boundary_.guard(grid_, points_, 0.0, guarded_.values());
  find_skin();
  try {
    reset_grid(0.0);
  } catch (const RunError& error) {
    throw std::invalid_argument(error.what());
  }
  note_geometry();
}

template <int Dim>
void QuasiStatic<Dim>::choose_schemes() {
  constexpr double locking = 0.4;  // Poisson ratio above which cells share one dilatation, as
                                   // where flow may keep the volume
  const bool literal = settings_.enforcement == Enforcement::literal;
  const double bandwidth = settings_.bandwidth.value_or(literal ? 1e-6 : 1e-3);
  const double gap = settings_.gap_bandwidth.value_or(0.05);
  require(bandwidth > 0.0 && gap > 0.0,
          "quasi_static: bandwidth and gap_bandwidth must be positive, got ", bandwidth, " and ",
          gap, " cells");
  choose_stiffness(false);
  ghost_ = settings_.ghost_penalty.value_or(literal ? 0.0 : 0.01);
  require(ghost_ >= 0.0, "quasi_static: ghost_penalty must not be negative, got ", ghost_);
  relaxation_ = settings_.relaxation.value_or(literal ? 0.0 : 0.5) * grid_.cell_size();
  reset_ = settings_.reset.value_or(literal ? 0.0 : 0.1) * grid_.cell_size();
  update_volumes_ = settings_.update_volumes.value_or(!literal);
  require(reset_ >= 0.0, "quasi_static: reset must not be negative, got ", *settings_.reset);
  require(settings_.body_force.size() <= Dim, "quasi_static: body_force has ",
          settings_.body_force.size(), " values, the scene has ", Dim, " axes");
  require(settings_.gravity.size() <= Dim, "quasi_static: gravity has ", settings_.gravity.size(),
          " values, the scene has ", Dim, " axes");
  for (Index body = 0; body < static_cast<Index>(solids_.elastic().size()); ++body) {
    const bool locks = solids_.can_yield(body) || solids_.elastic(body).poissons_ratio > locking;
    averaged_.push_back(settings_.b_bar.value_or(locks && !literal));
  }
}

template <int Dim>
void QuasiStatic<Dim>::choose_stiffness(bool moved_far) {
  // Stiff gaps at single points bend what a curved wall holds; points that have moved far, unevenly
  // spread, need them all the same.
  const bool literal = settings_.enforcement == Enforcement::literal;
  const bool soft = settings_.enforcement == Enforcement::mean_gap && !moved_far;
  moved_far_ = moved_far;
  scheme_ =
      SupportScheme::of(settings_.enforcement, settings_.bandwidth.value_or(literal ? 1e-6 : 1e-3),
                        settings_.gap_bandwidth.value_or(soft ? 0.5 : 0.05));
  if (solids_.can_yield()) {
    scheme_.consistency = 0.0;  // the traction of elastic moduli is not that of what yields
  }
  // Bandwidths that are asked for hold the ends of walls as all of them.
  reference_.softens_ends = settings_.enforcement == Enforcement::mean_gap &&
                            !settings_.bandwidth && !settings_.gap_bandwidth;
}

template <int Dim>
void QuasiStatic<Dim>::find_skin() {
  const auto is_set = [](char one) { return one != 0; };
  if (!settings_.has_weight() || std::none_of(averaged_.begin(), averaged_.end(), is_set)) {
    return;
  }
  std::vector<double> volume(averaged_.size(), 0.0);
  for (Index p = 0; p < points_.size(); ++p) {
    volume[points_.body()[p]] += std::as_const(points_).volume()[p];
  }
  reference_.skin = skin_of<Dim>(grid_, boundary_.bodies(), averaged_, volume);
}

/// What a body holds to where it does not touch it.
template <int Dim>
void QuasiStatic<Dim>::note_geometry() {
  const std::vector<Shape>& bodies = boundary_.bodies();
  if (bodies.empty()) {
    return;
  }
  for (std::size_t w = 0; w < boundary_.walls(); ++w) {
    const double off =
        distance_off(bodies, reference_.facets, static_cast<int>(w), grid_.cell_size());
    if (off > 0.0) {
      notes_.push_back(note("quasi_static.support-off", "quasi_static: ", boundary_.wall(w).what(),
                            " lies up to ", off,
                            " m off the bodies and holds them as if they reached it: move it "
                            "to their surface"));
    }
  }
  const auto near = cells_near_material(grid_, *reference_.state);
  if (const auto gap = narrowest_gap<Dim>(grid_, near, bodies)) {
    notes_.push_back(note("quasi_static.bridged-gap", "quasi_static: ", gap->in_words(Dim)));
  }
}

/// Domains of points that stand for a part of one cell end at its faces: beyond them they would
/// strain where their part of the body is not, and a uniform stress would be none.
template <int Dim>
void QuasiStatic<Dim>::start_half_widths(const std::vector<char>& in_cells) {
  half_width_ = std::make_unique<PointArray>(points_, Dim);
  const double h = grid_.cell_size();
  for (Index p = 0; p < points_.size(); ++p) {
    const double width = 0.5 * std::pow(points_.volume()[p], 1.0 / Dim) / h;
    const Vec<Dim> at = grid_.local(points_.template position<Dim>(p));
    const auto body = static_cast<std::size_t>(points_.body()[p]);
    const bool in_cell = body < in_cells.size() && in_cells[body] != 0;
    for (int axis = 0; axis < Dim; ++axis) {
      const double before = at[axis] - std::floor(at[axis]);
      const double room = in_cell ? std::min(before, 1.0 - before) : largest_half_width;
      (*half_width_)[Dim * p + axis] =
          h * std::clamp(std::min(width, room), least_half_width, largest_half_width);
    }
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                         \
  template QuasiStatic<Dim>::QuasiStatic(Points&, const Grid<Dim>&, ShapeFunction,       \
                                         const std::vector<Solid>&, QuasiStaticSettings, \
                                         std::vector<Shape>, const std::vector<char>&);  \
  template void QuasiStatic<Dim>::choose_schemes();                                      \
  template void QuasiStatic<Dim>::choose_stiffness(bool);                                \
  template void QuasiStatic<Dim>::note_geometry();                                       \
  template void QuasiStatic<Dim>::find_skin();                                           \
  template void QuasiStatic<Dim>::start_half_widths(const std::vector<char>&);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

std::unique_ptr<Physics> make_quasi_static(Points& points, const Vec3& lower, const Vec3& upper,
                                           double cell, ShapeFunction shape_function,
                                           const std::vector<Solid>& materials,
                                           QuasiStaticSettings settings, std::vector<Shape> shapes,
                                           const std::vector<char>& in_cells) {
  if (points.dimension() == 3) {
    return std::make_unique<QuasiStatic<3>>(points, Grid<3>(lower, upper, cell), shape_function,
                                            materials, std::move(settings), std::move(shapes),
                                            in_cells);
  }
  require(points.dimension() == 2, "quasi_static needs two or three dimensions, got ",
          points.dimension());
  return std::make_unique<QuasiStatic<2>>(points, Grid<2>(lower.head<2>(), upper.head<2>(), cell),
                                          shape_function, materials, std::move(settings),
                                          std::move(shapes), in_cells);
}

}  // namespace lapilli
