#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/filled_sums.hpp"
#include "geometry/random_points.hpp"
#include "lapilli/geometry/support.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;
using std::numbers::pi;

namespace {

// The nearest place has the distance, lies on the surface, and the way there is along the normal.
void require_nearest(const Shape& shape, const Vec3& x) {
  const double away = distance(shape, x);
  const Vec3 normal = gradient(shape, x);
  REQUIRE(std::abs(distance(shape, x - away * normal)) < 1e-10);
}

}  // namespace

TEST_CASE("distances from an ellipse are those of a full search") {
  const Ellipse ellipse{{0.3, -0.2}, {3.0, 1.0}};
  ellipse.check(2);
  for (const Vec3& x : random_points(60, 2, {Vec3(-4, -3, 0), Vec3(4, 3, 0)})) {
    double least = 1e300;
    for (int k = 0; k < 20000; ++k) {
      const double angle = 2 * pi * k / 20000;
      const Vec3 there(0.3 + 3 * std::cos(angle), -0.2 + std::sin(angle), 0);
      least = std::min(least, (there - x).norm());
    }
    // Half a step of the search is 2.4e-4 long: at a distance d it is 2.8e-8 / d too far.
    REQUIRE(std::abs(ellipse.distance(x)) == Approx(least).margin(std::min(1e-7 / least, 2.4e-4)));
    require_nearest(ellipse, x);
  }
}

TEST_CASE("distances hold on axes, in the middle and for circles") {
  const Ellipse ellipse{{0, 0}, {3.0, 1.0}};
  REQUIRE(ellipse.distance(Vec3(0, 0, 0)) == Approx(-1.0));
  REQUIRE(ellipse.distance(Vec3(4, 0, 0)) == Approx(1.0));
  REQUIRE(ellipse.distance(Vec3(0, -3, 0)) == Approx(2.0));
  REQUIRE(ellipse.distance(Vec3(3, 0, 0)) == Approx(0.0).margin(1e-15));
  // Inside the evolute the nearest place is off the axis: at x = 9 y / 8.
  REQUIRE(ellipse.distance(Vec3(1, 0, 0)) == Approx(-std::hypot(1.0 / 8, std::sqrt(1 - 9.0 / 64))));
  const Ellipse tall{{0, 0}, {1.0, 3.0}};
  REQUIRE(tall.distance(Vec3(0, 1, 0)) == Approx(ellipse.distance(Vec3(1, 0, 0))));
  const Ellipse circle{{0, 0}, {2.0, 2.0}};
  REQUIRE(circle.distance(Vec3(0, 3, 0)) == Approx(1.0));
  REQUIRE(circle.distance(Vec3(-1, 0, 0)) == Approx(-1.0));
  const Ellipsoid ball{{0, 0, 0}, {2.0, 2.0, 2.0}};
  REQUIRE(ball.distance(Vec3(0, 0, 0)) == Approx(-2.0));
  const Ellipsoid egg{{0, 0, 0}, {3.0, 2.0, 1.0}};
  for (const Vec3& x : random_points(200, 3, {Vec3(-4, -3, -2), Vec3(4, 3, 2)})) {
    REQUIRE(ball.distance(x) == Approx(x.norm() - 2.0).margin(1e-13));
    require_nearest(egg, x);
  }
}

TEST_CASE("turned ellipses have their area, centroid and bounds") {
  const Shape turned = Rotated{Shape(Ellipse{{0.5, 0.2}, {3.0, 1.0}}), 20.0, {}};
  FillOptions options;
  options.clip = true;
  const auto points = fill(turned, {Vec3(-5, -5, 0), 0.4, 2}, options, 2);
  REQUIRE(total(points) == Approx(3 * pi).epsilon(1e-8));
  const Vec3 middle = rotation(20.0, Vec3::UnitZ()) * Vec3(0.5, 0.2, 0);
  REQUIRE((centroid(points) - middle).norm() < 1e-8);
  const TightBounds tight = tight_bounds(turned);
  REQUIRE(tight.is_tight);
  const double c = std::cos(pi / 9), s = std::sin(pi / 9);
  REQUIRE(tight.box.upper[0] == Approx(middle[0] + std::hypot(3 * c, s)));
  REQUIRE(tight.box.lower[1] == Approx(middle[1] - std::hypot(3 * s, c)));
  const auto egg =
      fill(Ellipsoid{{0, 0, 0}, {1.5, 1.25, 1.0}}, {Vec3(-3, -3, -3), 0.5, 2}, options, 3);
  REQUIRE(total(egg) == Approx(2.5 * pi).epsilon(2e-5));
}

TEST_CASE("unusable ellipses are refused") {
  REQUIRE_THROWS_WITH(check(Ellipse{{0, 0}, {1}}, 2), Contains("semi_axes needs 2 numbers"));
  REQUIRE_THROWS_WITH(check(Ellipse{{0, 0}, {1, 0}}, 2), Contains("semi_axes must be positive"));
  REQUIRE_THROWS_WITH(check(Ellipsoid{{0, 0, 0}, {1, 1, 1}}, 2),
                      Contains("needs a grid of 3 dimensions"));
}
