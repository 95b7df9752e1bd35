#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/filled_sums.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

TEST_CASE("a rod is filled at a quarter and three quarters of each cell, in order") {
  const auto points = fill(Box{{0.0}, {1.0}}, {Vec3::Zero(), 0.5, 2}, {}, 1);
  REQUIRE(points.position == std::vector<double>{0.125, 0.375, 0.625, 0.875});
  REQUIRE(points.volume == std::vector<double>(4, 0.25));
  REQUIRE(points.spacing == 0.25);
}

TEST_CASE("a rectangle is filled exactly, first axis fastest") {
  const auto points = fill(Box{{0, 0}, {1, 0.5}}, {Vec3(-2, -2, 0), 0.5, 1}, {}, 2);
  REQUIRE(points.position == std::vector<double>{0.25, 0.25, 0.75, 0.25});
  REQUIRE(total(fill(Box{{0, 0}, {1, 0.5}}, {Vec3(-2, -2, 0), 0.1, 3}, {}, 2)) == Approx(0.5));
  REQUIRE(fill(Box{{0, 0, 0}, {1, 1, 1}}, {Vec3::Zero(), 0.25, 2}, {}, 3).size() == 512);
}

TEST_CASE("the ring of the virtual flux paper holds the sites whose radius lies in 1 to 5") {
  const auto points = fill(Annulus{{0, 0}, 1, 5}, {Vec3(-5.5, -5.5, 0), 0.1, 2}, {}, 2);
  int count = 0;
  for (int i = 0; i < 220; ++i) {
    for (int j = 0; j < 220; ++j) {
      const double r = std::hypot(-5.5 + (i + 0.5) * 0.05, -5.5 + (j + 0.5) * 0.05);
      count += r >= 1.0 && r <= 5.0;
    }
  }
  REQUIRE(points.size() == static_cast<std::size_t>(count));
  // A staircase errs by a share of its boundary boxes that changes sign: far below spacing/radius.
  REQUIRE(total(points) == Approx(24 * std::numbers::pi).epsilon(1e-3));
}

TEST_CASE("sites on the surface are inside, wherever the lattice stands") {
  // Spacing 0.25: sites at odd multiples of 0.125, and the disk's rim passes through four of them.
  const auto here = fill(Disk{{0.125, 0.125}, 1.0}, {Vec3(0, 0, 0), 0.5, 2}, {}, 2);
  for (double shift : {1024.0, -4096.5, 1e6}) {
    const auto there =
        fill(Disk{{0.125 + shift, 0.125 - shift}, 1.0}, {Vec3(shift, -shift, 0), 0.5, 2}, {}, 2);
    REQUIRE(there.size() == here.size());
    for (std::size_t k = 0; k < here.size(); ++k) {
      REQUIRE(there.position[2 * k] - shift == here.position[2 * k]);
      REQUIRE(there.position[2 * k + 1] + shift == here.position[2 * k + 1]);
    }
  }
  REQUIRE(here.position[0] == 0.125);
  REQUIRE(here.position[1] == -0.875);
  // The rule holds at a spacing that binary numbers cannot hold as well.
  REQUIRE(fill(Box{{0.05, 0.05}, {0.95, 0.95}}, {Vec3::Zero(), 0.1, 1}, {}, 2).size() == 100);
}

TEST_CASE("a turned lattice fills a turned square as an upright lattice fills an upright one") {
  FillOptions options;
  options.degrees = 30;
  options.center = {1, 2};
  const Shape square = Box{{0, 1}, {2, 3}};
  const auto upright = fill(square, {Vec3::Zero(), 0.5, 2}, {}, 2);
  const auto turned = fill(Rotated{square, 30, {1, 2}}, {Vec3::Zero(), 0.5, 2}, options, 2);
  REQUIRE(turned.size() == upright.size());
  const Mat3 turn = rotation(30, Vec3::UnitZ());
  for (std::size_t k = 0; k < upright.size(); ++k) {
    const Vec3 from(upright.position[2 * k] - 1, upright.position[2 * k + 1] - 2, 0);
    const Vec3 to = turn * from;
    REQUIRE(turned.position[2 * k] == Approx(1 + to[0]).margin(1e-14));
    REQUIRE(turned.position[2 * k + 1] == Approx(2 + to[1]).margin(1e-14));
  }
}

TEST_CASE("jittered points stay near their sites and inside; the seed decides") {
  FillOptions options;
  options.jitter = 0.25;
  const Shape disk = Disk{{0, 0}, 1};
  const Lattice lattice{Vec3(-2, -2, 0), 0.25, 2};
  const auto sites = fill(disk, lattice, {}, 2);
  const auto points = fill(disk, lattice, options, 2);
  REQUIRE(points.size() == sites.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < points.position.size(); ++k) {
    largest = std::max(largest, std::abs(points.position[k] - sites.position[k]));
  }
  REQUIRE(largest <= 0.25 * 0.125);
  REQUIRE(largest > 0.24 * 0.125);  // 400 uniform draws miss the last 4 percent once in 1e7
  for (std::size_t k = 0; k < points.size(); ++k) {
    REQUIRE(std::hypot(points.position[2 * k], points.position[2 * k + 1]) <= 1.0);
  }
  REQUIRE(fill(disk, lattice, options, 2).position == points.position);
  options.seed = 2;
  REQUIRE(fill(disk, lattice, options, 2).position != points.position);
}

TEST_CASE("infinite shapes end at the grid") {
  FillOptions options;
  options.within = {Vec3(0, 0, 0), Vec3(1, 1, 0)};
  const auto points = fill(HalfSpace{{0, 0.5}, {0, 1}}, {Vec3::Zero(), 0.25, 1}, options, 2);
  REQUIRE(points.size() == 8);
  REQUIRE_THROWS_WITH(fill(HalfSpace{{0, 0.5}, {0, 1}}, {Vec3::Zero(), 0.25, 1}, {}, 2),
                      Contains("no end along the x axis"));
}

TEST_CASE("points per cell is a power of the dimension") {
  REQUIRE(points_per_axis(7, 1) == 7);
  REQUIRE(points_per_axis(1, 2) == 1);
  REQUIRE(points_per_axis(9, 2) == 3);
  REQUIRE(points_per_axis(27, 3) == 3);
  REQUIRE(points_per_axis(1000000, 3) == 100);
  REQUIRE_THROWS_WITH(points_per_axis(5, 2), Contains("4 or 9, got 5"));
  REQUIRE_THROWS_WITH(points_per_axis(9, 3), Contains("8 or 27, got 9"));
  REQUIRE_THROWS_WITH(points_per_axis(26, 3), Contains("8 or 27, got 26"));
  REQUIRE_THROWS_WITH(points_per_axis(0, 2), Contains("at least 1, got 0"));
}

TEST_CASE("unusable fills are refused") {
  const Shape disk = Disk{{0, 0}, 1};
  const Lattice lattice{Vec3::Zero(), 0.25, 2};
  const auto refused = [&](const Lattice& on, const FillOptions& options, const std::string& text) {
    REQUIRE_THROWS_WITH(fill(disk, on, options, 2), Contains(text));
  };
  FillOptions options;
  options.jitter = 0.6;
  refused(lattice, options, "jitter must be 0 to 0.5 of the spacing, got 0.6");
  options.jitter = 0.0;
  options.clip = options.random = true;
  refused(lattice, options, "give clip or random, not both");
  options.clip = false;
  options.jitter = 0.1;
  refused(lattice, options, "random or jitter, not both");
  refused({Vec3::Zero(), -1, 2}, {}, "cell must be positive and finite, got -1");
  refused({Vec3::Zero(), 1, 0}, {}, "points_per_axis must be at least 1, got 0");
  refused({Vec3::Zero(), 1e-6, 2}, {}, "more than 4e9 lattice sites");
  refused({Vec3(0.5, 0.5, 0), 16, 1}, {}, "no point of the lattice of spacing 16 m lies inside");
  options = {};
  options.degrees = 10;
  REQUIRE_THROWS_WITH(fill(Box{{0.0}, {1.0}}, lattice, options, 1), Contains("cannot be turned"));
}
