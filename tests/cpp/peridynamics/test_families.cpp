#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "lapilli/core/parallel.hpp"
#include "lapilli/peridynamics/families.hpp"

using namespace lapilli;

namespace {

std::unique_ptr<Points> random_points(int dimension, Index count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::vector<double> position(static_cast<std::size_t>(count * dimension));
  for (double& x : position) {
    x = place(generator);
  }
  auto points = std::make_unique<Points>(dimension);
  points->append(position, std::vector<double>(static_cast<std::size_t>(count), 1.0), 0);
  return points;
}

}  // namespace

TEST_CASE("families hold exactly the points within horizon and skin") {
  for (const int dimension : {1, 2, 3}) {
    auto points = random_points(dimension, 400, 7);
    const double reach = dimension == 3 ? 0.2 : 0.1;
    Families families(*points, reach, 0.02, {FamilyRole{}});
    families.update();
    for (Index i = 0; i < points->size(); ++i) {
      std::set<Index> expected, found;
      for (Index j = 0; j < points->size(); ++j) {
        double squared = 0.0;
        for (int d = 0; d < dimension; ++d) {
          squared += std::pow(
              points->position()[i * dimension + d] - points->position()[j * dimension + d], 2);
        }
        if (j != i && std::sqrt(squared) < reach + 0.02) {
          expected.insert(j);
        }
      }
      for (Index bond = families.begin(i); bond < families.end(i); ++bond) {
        found.insert(families.neighbour(bond));
      }
      REQUIRE(found == expected);
      REQUIRE((families.padded_end(i) - families.begin(i)) % 4 == 0);
    }
  }
}

TEST_CASE("families are searched again only when a point has moved half the skin") {
  auto points = random_points(2, 100, 3);
  Families families(*points, 0.2, 0.04, {FamilyRole{}});
  REQUIRE(families.update());
  points->position()[10] += 0.019;
  points->moved();
  REQUIRE_FALSE(families.update());
  points->position()[10] += 0.002;
  points->moved();
  REQUIRE(families.update());
  REQUIRE(families.searches() == 2);
}

TEST_CASE("families trust the path of the points until it spends the skin") {
  auto points = random_points(2, 200, 5);
  Families families(*points, 0.1, 0.02, {FamilyRole{}});
  families.update();
  // To and fro: the path adds up, the displacement does not; looking again resets the bound.
  for (int step = 0; step < 40; ++step) {
    points->position()[10] += step % 2 == 0 ? 0.004 : -0.004;
    points->moved_at_most(0.004);
    REQUIRE_FALSE(families.update());
  }
  points->position()[10] += 0.0101;
  points->moved_at_most(0.0101);
  REQUIRE(families.update());
  // An unknown move is looked at, however small the known ones.
  points->position()[10] -= 0.0101;
  points->moved();
  points->moved_at_most(1e-6);
  REQUIRE(families.update());
  REQUIRE(families.searches() == 3);
}

TEST_CASE("pieces reach as far as their families") {
  auto points = random_points(2, 700, 5);
  Families families(*points, 0.2, 0.02, {FamilyRole{}});
  families.update();
  const std::vector<TaskRange> reach = families.reach(256);
  REQUIRE(reach.size() == 3);
  for (Index i = 0; i < 700; ++i) {
    for (Index bond = families.begin(i); bond < families.end(i); ++bond) {
      REQUIRE(reach[i / 256].first <= families.neighbour(bond) / 256);
      REQUIRE(reach[i / 256].last >= families.neighbour(bond) / 256);
    }
  }
}

TEST_CASE("families list walls last, are the same for any threads and after a resume") {
  auto points = random_points(2, 1500, 5);
  points->append(std::vector<double>{0.5, 0.5, 0.51, 0.5}, std::vector<double>{1.0, 1.0}, 1);
  const std::vector<FamilyRole> roles = {{Member::owner, false}, {Member::neighbour, true}};
  set_thread_count(1);
  Families alone(*points, 0.1, 0.02, roles);
  alone.update();
  Archive archive;
  alone.save(archive, "families");
  set_thread_count(4);
  Families together(*points, 0.1, 0.02, roles);
  together.update();
  points->position()[0] += 0.005;  // within the skin: a resumed run must not notice
  Families resumed(*points, 0.1, 0.02, roles);
  resumed.load(archive, "families");
  set_thread_count(0);
  REQUIRE(alone.bonds() == together.bonds());
  REQUIRE(
      std::equal(alone.neighbours(), alone.neighbours() + alone.bonds(), together.neighbours()));
  REQUIRE(std::equal(alone.neighbours(), alone.neighbours() + alone.bonds(), resumed.neighbours()));
  REQUIRE(alone.begin(1500) == alone.padded_end(1500));
  bool met = false;
  for (Index i = 0; i < 1500; ++i) {
    for (Index bond = alone.wall_begin(i); bond < alone.end(i); ++bond) {
      REQUIRE(alone.neighbour(bond) >= 1500);
      met = true;
    }
  }
  REQUIRE(met);
}

TEST_CASE("a position that is no number is named") {
  auto points = random_points(2, 10, 3);
  Families families(*points, 0.2, 0.04, {FamilyRole{}});
  families.update();
  points->position()[6] = std::nan("");
  points->moved();
  REQUIRE_THROWS_WITH(families.update(), Catch::Contains("point 3"));
}
