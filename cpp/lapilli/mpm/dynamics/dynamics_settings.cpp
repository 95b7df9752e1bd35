#include "lapilli/mpm/dynamics/dynamics_settings.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/in_brackets.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

void check_vector(const std::vector<double>& values, int dimension, const char* what) {
  require(static_cast<int>(values.size()) == dimension, what, " needs ", dimension,
          " numbers, one an axis, got ", values.size());
  for (const double value : values) {
    require(std::isfinite(value), what, " must be finite, got ", value);
  }
}

void check_walls(const std::vector<GridBoundary>& walls, int dimension) {
  bool taken[6] = {};
  for (const GridBoundary& wall : walls) {
    const GridFace face = std::visit([](const auto& known) { return known.face; }, wall);
    const int number = static_cast<int>(face);
    require(number < 2 * dimension, "dynamics.grid_boundaries: the grid has no face ",
            name_of(face), " in ", dimension, " dimensions");
    require(!taken[number], "dynamics.grid_boundaries: face ", name_of(face), " has two walls");
    taken[number] = true;
    if (const auto* rough = std::get_if<FrictionalBoundary>(&wall)) {
      require(std::isfinite(rough->coefficient) && rough->coefficient >= 0.0,
              "dynamics.grid_boundaries: coefficient must not be negative, got ",
              rough->coefficient);
    }
  }
}

}  // namespace

void check(const DynamicsSettings& settings, int dimension) {
  require(!settings.gravity_factor.is_function(),
          "dynamics.gravity_factor must be a number or a table in time, got a function");
  require(!settings.gravity.empty() ||
              (settings.gravity_factor.is_constant() && settings.gravity_factor.at(0.0) == 1.0),
          "dynamics.gravity_factor multiplies dynamics.gravity, which is missing");
  require(!settings.damping_until || settings.local_damping > 0.0,
          "dynamics.damping_until ends dynamics.local_damping, which is 0");
  if (!settings.gravity.empty()) {
    check_vector(settings.gravity, dimension, "dynamics.gravity");
  }
  require(std::isfinite(settings.blend_rate) && settings.blend_rate >= 0.0,
          "dynamics.blend_rate must not be negative, got ", settings.blend_rate);
  require(settings.pic_fraction >= 0.0 && settings.pic_fraction <= 1.0,
          "dynamics.pic_fraction must lie in [0, 1], got ", settings.pic_fraction);
  require(settings.courant > 0.0 && settings.courant <= 1.0,
          "dynamics.courant must lie in (0, 1], got ", settings.courant);
  check_walls(settings.grid_boundaries, dimension);
  for (std::size_t k = 0; k < settings.obstacles.size(); ++k) {
    check(settings.obstacles[k], dimension, static_cast<int>(k));
  }
  for (std::size_t k = 0; k < settings.contacts.size(); ++k) {
    check(settings.contacts[k], static_cast<int>(k));
  }
  for (const DynamicsBoundary& law : settings.boundaries) {
    if (const auto* traction = std::get_if<Traction>(&law)) {
      check_vector(traction->value, dimension, "dynamics.boundaries: the value of a traction");
    }
  }
}

std::vector<Note> warnings(const DynamicsSettings& settings) {
  std::vector<Note> all;
  const bool flip = settings.transfer == VelocityTransfer::flip;
  if (settings.transfer != VelocityTransfer::blended_apic &&
      !(flip && settings.pic_fraction == 0.0)) {
    all.push_back(
        note("dynamics.damping-transfer", "dynamics.transfer ", name_of(settings.transfer),
             flip ? message(" with pic_fraction ", settings.pic_fraction) : std::string(),
             " damps once a step: motion depends on the time step; blended_apic does not"));
  }
  if (settings.stress_update == StressUpdate::usl) {
    all.push_back(note(
        "dynamics.damping-usl",
        "dynamics.stress_update usl damps what vibrates, by up to a quarter of its energy in a "
        "hundred periods; musl does not"));
  }
  for (std::size_t k = 0; k < settings.obstacles.size(); ++k) {
    const Obstacle& one = settings.obstacles[k];
    const std::string name = message("dynamics.obstacles.", k, in_brackets(one.name));
    if (one.revolutions_per_second != 0.0 && one.center.empty() && !one.mass) {
      all.push_back(
          note("dynamics.obstacle-center", name,
               " turns about the origin of the grid: give center to turn it about another "
               "place"));
    }
    if (!one.separation && settings.local_damping == 0.0) {
      all.push_back(
          note("dynamics.hanging-energy", name,
               " holds what has touched it: without local_damping what hangs from it gains "
               "energy in steps of uneven size"));
    }
  }
  return all;
}

}  // namespace lapilli
