#include <catch2/catch.hpp>
#include <utility>

#include "lapilli/core/points.hpp"

using namespace lapilli;

namespace {

using Numbers = std::vector<double>;
using Indices = std::vector<Index>;

/// Point k at (k, -k), of volume k + 1, with k and 10 k in an array.
struct Made {
  Made() : points(2), array((fill(points), points), 2) {
    for (Index row = 0; row < points.size(); ++row) {
      array[2 * row] = static_cast<double>(row);
      array[2 * row + 1] = 10.0 * static_cast<double>(row);
    }
  }
  static void fill(Points& points) {
    points.append(Numbers{0, 0, 1, -1, 2, -2}, Numbers{1, 2, 3}, 0);
    points.append(Numbers{3, -3, 4, -4}, Numbers{4, 5}, 1);
  }
  Points points;
  PointArray array;
};

void check_rows(const Made& made, const Indices& ids) {
  const Points& points = made.points;
  REQUIRE(Indices(points.id().begin(), points.id().end()) == ids);
  for (std::size_t row = 0; row < ids.size(); ++row) {
    const auto id = static_cast<double>(ids[row]);
    REQUIRE(points.position()[2 * row] == id);
    REQUIRE(points.position()[2 * row + 1] == -id);
    REQUIRE(points.volume()[row] == id + 1);
    REQUIRE(points.body()[row] == (ids[row] < 3 ? 0 : 1));
    REQUIRE(made.array.values()[2 * row] == id);
    REQUIRE(made.array.values()[2 * row + 1] == 10.0 * id);
  }
  REQUIRE(made.array.values().size() == 2 * ids.size());
}

}  // namespace

TEST_CASE("points that leave take their rows of every array along, the others keep their order") {
  Made made;
  made.points.permute(Indices{4, 2, 0, 3, 1});
  const auto [gone, left] = GENERATE(std::pair<Indices, Indices>{{}, {4, 2, 0, 3, 1}},
                                     std::pair<Indices, Indices>{{0}, {2, 0, 3, 1}},
                                     std::pair<Indices, Indices>{{4}, {4, 2, 0, 3}},
                                     std::pair<Indices, Indices>{{1, 2}, {4, 3, 1}},
                                     std::pair<Indices, Indices>{{0, 2, 4}, {2, 3}},
                                     std::pair<Indices, Indices>{{0, 1, 2, 3, 4}, {}});
  const double* address = made.array.data();
  const Index ordering = made.points.ordering();
  made.points.leave(gone);
  made.points.remove_leaving();
  check_rows(made, left);
  REQUIRE(made.points.leaving().empty());
  REQUIRE(made.points.created() == 5);
  REQUIRE(made.points.ordering() > ordering);
  REQUIRE(made.array.data() == address);
}

TEST_CASE("rows and places in order of id, with gaps where points have left") {
  Made made;
  made.points.permute(Indices{4, 2, 0, 3, 1});
  made.points.leave({2});  // id 0
  made.points.remove_leaving();
  REQUIRE(made.points.places_by_id() == Indices{3, 1, 2, 0});  // of ids 4 2 3 1
  REQUIRE(made.points.rows_by_id() == Indices{3, 1, 2, 0});
}

TEST_CASE("what was saved after some had left comes back as many") {
  Made made, other;
  made.points.leave({1, 3});
  made.points.remove_leaving();
  Archive archive;
  made.points.save(archive);
  archive.write("array", std::as_const(made.array).values());
  other.points.load(archive);
  archive.read("array", other.array.values());
  check_rows(other, {0, 2, 4});
}
