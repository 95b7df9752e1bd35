#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>

#include "lapilli/geometry/step_of_motion.hpp"

namespace lapilli {
namespace {

constexpr double cell = 0.1, pi = std::numbers::pi;

using Motions = std::vector<std::optional<Motion>>;

/// Two bodies of a point each.
template <int Dim>
std::unique_ptr<Points> two(const std::vector<double>& first, const std::vector<double>& second) {
  auto points = std::make_unique<Points>(Dim);
  points->append(first, std::vector<double>{1.0}, 0);
  points->append(second, std::vector<double>{1.0}, 1);
  return points;
}

Rotation turning(double turns, const std::vector<double>& center = {}) {
  Rotation motion;
  motion.revolutions_per_second = turns;
  motion.center = center;
  return motion;
}

TEST_CASE("The fastest point goes a quarter of a cell in a step of motion") {
  const auto points = two<2>({3.0, 4.0}, {1.0, 0.0});
  CHECK(std::isinf(step_of_motion<2>(*points, Motions(2), cell)));
  const Translation slide{{0.3, -0.4}};
  CHECK(step_of_motion<2>(*points, {std::nullopt, Motion(slide)}, cell) == Approx(0.025 / 0.5));
  CHECK(step_of_motion<2>(*points, {Motion(turning(-2.0)), std::nullopt}, cell) ==
        Approx(0.025 / (4.0 * pi * 5.0)));
  CHECK(step_of_motion<2>(*points, {Motion(turning(2.0, {3.0, 3.0})), Motion(slide)}, cell) ==
        Approx(0.025 / (4.0 * pi)));
}

TEST_CASE("Small bodies turn by a fortieth of a turn at most") {
  const auto points = two<2>({0.01, 0.0}, {0.0, 0.01});
  CHECK(step_of_motion<2>(*points, Motions(2, Motion(turning(2.0))), cell) == Approx(1.0 / 80.0));
}

TEST_CASE("In space a turn counts by the distance from its axis, of any length") {
  const auto points = two<3>({0.0, 3.0, 7.0}, {0.0, 0.0, 9.0});
  Rotation motion = turning(1.0, {0.0, 1.0, 0.0});
  motion.axis = {0.0, 0.0, -5.0};
  CHECK(step_of_motion<3>(*points, Motions(2, Motion(motion)), cell) == Approx(0.025 / (4.0 * pi)));
}

TEST_CASE("A swirl is fastest where it is, not at its rim") {
  const auto points = two<2>({0.5, 0.0}, {1.0, 0.0});
  Swirl motion;
  motion.revolutions_per_second = 1.0;
  motion.shear = 8.0;
  CHECK(step_of_motion<2>(*points, Motions(2, Motion(motion)), cell) ==
        Approx(0.025 / (2.0 * pi * 0.5 * 7.0)));
}

}  // namespace
}  // namespace lapilli
