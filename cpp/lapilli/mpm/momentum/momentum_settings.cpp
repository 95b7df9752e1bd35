#include "lapilli/mpm/momentum/momentum_settings.hpp"

#include <algorithm>
#include <cmath>

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

void check_walls(const std::vector<GridWall>& walls, int dimension) {
  bool taken[6] = {};
  for (const GridWall& wall : walls) {
    const GridFace face = std::visit([](const auto& known) { return known.face; }, wall);
    const int number = static_cast<int>(face);
    require(number < 2 * dimension, "momentum.walls: the grid has no face ", name_of(face), " in ",
            dimension, " dimensions");
    require(!taken[number], "momentum.walls: face ", name_of(face), " has two walls");
    taken[number] = true;
    if (const auto* rough = std::get_if<FrictionalWall>(&wall)) {
      require(std::isfinite(rough->coefficient) && rough->coefficient >= 0.0,
              "momentum.walls: coefficient must not be negative, got ", rough->coefficient);
    }
  }
}

}  // namespace

void check(const MomentumSettings& settings, int dimension) {
  if (!settings.gravity.empty()) {
    check_vector(settings.gravity, dimension, "momentum.gravity");
  }
  require(std::isfinite(settings.blend_rate) && settings.blend_rate >= 0.0,
          "momentum.blend_rate must not be negative, got ", settings.blend_rate);
  require(settings.pic_share >= 0.0 && settings.pic_share <= 1.0,
          "momentum.pic_share must lie in [0, 1], got ", settings.pic_share);
  require(settings.step_safety > 0.0 && settings.step_safety <= 1.0,
          "momentum.step_safety must lie in (0, 1], got ", settings.step_safety);
  check_walls(settings.walls, dimension);
  for (std::size_t k = 0; k < settings.obstacles.size(); ++k) {
    check(settings.obstacles[k], dimension, static_cast<int>(k));
  }
  for (const MomentumBoundary& law : settings.boundaries) {
    if (const auto* traction = std::get_if<Traction>(&law)) {
      check_vector(traction->value, dimension, "momentum.boundaries: the value of a traction");
    }
  }
}

std::vector<std::string> warnings(const MomentumSettings& settings) {
  const bool flip = settings.transfer == VelocityTransfer::flip;
  if (settings.transfer == VelocityTransfer::blended_apic || (flip && settings.pic_share == 0.0)) {
    return {};
  }
  return {message("momentum.transfer ", name_of(settings.transfer),
                  flip ? message(" with pic_share ", settings.pic_share) : std::string(),
                  " damps once a step: motion depends on the time step; blended_apic does not")};
}

}  // namespace lapilli
