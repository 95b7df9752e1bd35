// Surfaces that do not lie on the bodies they are meant for, and bodies nearer to each other than
// the grid can tell: right all the same, or said.
#include <catch2/catch.hpp>
#include <random>

#include "lapilli/mpm/surface/narrow_gap.hpp"
#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;
using Catch::Matchers::Contains;

namespace {

const LinearElastic rubber{1000.0, 1e7, 0.3};
const Grid<2> room(Vec<2>(-1.3, -1.3), Vec<2>(1.3, 1.3), 0.1);

void fill_all(Points& points, const std::vector<Shape>& bodies) {
  for (const Shape& body : bodies) {
    fill_clipped(points, room, body, 2);
  }
}

SurfaceSettings line(const Corners& corners) { return {{}, false, numbers(corners), {}}; }

/// What a physics of these bodies, held at `held`, says when it is made: warnings or the refusal.
std::string said(const std::vector<Shape>& bodies, const SurfaceSettings& held,
                 std::vector<TractionSettings> tractions = {}) {
  Points points(2);
  fill_all(points, bodies);
  QuasiStaticSettings settings;
  settings.supports = {{"held", HeldMotion::fixed, held, {}}};
  settings.tractions = std::move(tractions);
  std::string all;
  try {
    QuasiStatic<2> physics(points, room, ShapeFunction::linear, {rubber}, settings, bodies);
    for (const std::string& warning : physics.warnings()) {
      all += warning + "\n";
    }
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return all;
}

Shape box(double left, double low, double right, double high) {
  return Box{{left, low}, {right, high}};
}

}  // namespace

TEST_CASE("a pressure on the wrong side of a body is refused, whatever its surface") {
  const Disk pin{{0.0, 0.0}, 0.3};
  for (const Shape& outline : {Shape(Disk{{0.013, 0.021}, 1.0}), box(-0.9, -0.9, 0.9, 0.9),
                               Shape(Polygon{{{-0.9, -0.9}, {0.9, -0.7}, {0.3, 0.9}}})}) {
    const Shape body = Difference{outline, Shape(pin)};
    for (const bool inside : {true, false}) {
      const std::string words =
          said({body}, {Shape(pin), false, {}, {}}, {{"p", {outline, inside, {}, {}}, {}, 1e3}});
      INFO(kind_of(outline) << ", inside " << inside << ": " << words);
      CHECK(words.empty() == inside);
      CHECK((inside || words.find("set inside = true") != std::string::npos));
    }
  }
  for (const double low : {0.0, 0.03, 0.07}) {
    const Vec<2> right(1.0, low + 1.0), left(0.0, low + 1.0);
    const SurfaceSettings base = line({{0.0, low}, {1.0, low}});
    const std::vector<Shape> block = {box(0.0, low, 1.0, low + 1.0)};
    CHECK(said(block, base, {{"p", line({right, left}), {}, 1e3}}).empty());
    CHECK_THAT(said(block, base, {{"p", line({left, right}), {}, 1e3}}), Contains("turn its line"));
    // A traction has a direction of its own, and between two bodies there is no side.
    CHECK(said(block, base, {{"t", line({left, right}), {0.0, -1e3}}}).empty());
    const std::vector<Shape> two = {box(0.0, low, 1.0, 0.5), box(0.0, 0.5, 1.0, 1.0)};
    CHECK(said(two, base, {{"p", line({{0.0, 0.5}, {1.0, 0.5}}), {}, 1e3}}).empty());
  }
}

TEST_CASE("a support drawn off the body holds it as one that lies on it, and says so") {
  const auto pressed = [](double low, double gap, std::string& words) {
    const std::vector<Shape> block = {box(0.0, low, 1.0, low + 1.0)};
    Points points(2);
    fill_all(points, block);
    QuasiStaticSettings settings;
    settings.supports = {
        {"held", HeldMotion::fixed, line({{0.0, low - gap}, {1.0, low - gap}}), {}}};
    settings.tractions = {{"p", line({{1.0, low + 1.0}, {0.0, low + 1.0}}), {}, 1e3}};
    QuasiStatic<2> physics(points, room, ShapeFunction::linear, {rubber}, settings, block);
    physics.advance({0.0, 1.0, 0});
    for (const std::string& warning : physics.warnings()) {
      words += warning;
    }
    double most = 0.0;
    for (const double moved : physics.displacement()) {
      most = std::max(most, std::abs(moved));
    }
    return most;
  };
  for (const double low : {0.0, 0.03, 0.05}) {
    std::string none;
    const double right = pressed(low, 0.0, none);
    CHECK(none.empty());
    for (const double gap : {1e-5, 1e-3, 0.01, 0.03, 0.07}) {
      std::string words;
      const double moved = pressed(low, gap, words);
      INFO("base at " << low << ", wall " << gap << " below: " << moved / right << ", " << words);
      CHECK(moved > 0.999 * right);
      CHECK(moved < (1.01 + 5.0 * gap) * right);  // as if the block were longer
      CHECK((words.find("off the bodies") != std::string::npos) == (gap > 2e-3));
    }
  }
}

TEST_CASE("gaps that nodes bridge are found wherever they lie, and only those") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(0.0, 0.1), any_width(0.01, 0.25);
  for (int k = 0; k < 40; ++k) {
    const double low = -0.8 + anywhere(random), width = any_width(random), from = low + 0.5;
    const double to = from + width;
    const std::vector<Shape> two = {box(-0.5, low, 0.53, from), box(-0.5, to, 0.53, to + 0.5)};
    const Shape slit = Difference{box(-0.5, low, 0.53, to + 0.5), box(-0.2, from, 0.6, to)};
    const bool shared = std::floor(10.0 * to + 1e-9) - std::ceil(10.0 * from - 1e-9) + 1 < 1.5;
    for (const auto& bodies : {two, std::vector<Shape>{slit}}) {
      for (const Shape& body : bodies) {
        check(body, 2);
      }
      const std::vector<char> cells(static_cast<std::size_t>(room.cell_count()), 1);
      const auto gap = narrowest_gap<2>(room, cells, bodies);
      INFO("gap from " << from << " to " << to << ", bodies " << bodies.size());
      CHECK(gap.has_value() == shared);
      if (gap) {
        CHECK(gap->width == Approx(width).epsilon(1e-3));
        CHECK(gap->middle[1] == Approx(0.5 * (from + to)).margin(1e-3));
      }
    }
  }
}

TEST_CASE("bodies that touch, corners and bodies far apart have no gap") {
  const std::vector<std::vector<Shape>> scenes = {
      {box(-0.5, -0.5, 0.5, 0.0), box(-0.5, 0.0, 0.5, 0.5)},
      {box(-0.5, -0.5, 0.5, 0.0), box(-0.5, 1e-4, 0.5, 0.5)},
      {box(-0.5, -0.5, 0.5, 0.02), box(-0.5, 0.0, 0.5, 0.5)},
      {box(-0.5, -0.5, 0.5, 0.0), box(-0.5, 0.21, 0.5, 0.5)},
      {Polygon{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.0}, {0.0, 0.0}, {0.0, 0.5}, {-0.5, 0.5}}}},
      {Disk{{-0.503, 0.0}, 0.5}, Disk{{0.497, 0.01}, 0.5}},
      {Disk{{0.0, 0.503}, 0.5}, box(-1.0, -0.5, 1.0, 0.003)},
      {Annulus{{0.0, 0.0}, 0.3, 0.8}, Disk{{0.0, 0.0}, 0.3}},
      {Rotated{box(-0.5, -0.5, 0.5, 0.0), 30.0, {}}}};
  const std::vector<char> cells(static_cast<std::size_t>(room.cell_count()), 1);
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    for (const Shape& body : scenes[k]) {
      check(body, 2);
    }
    const auto gap = narrowest_gap<2>(room, cells, scenes[k]);
    INFO("scene " << k << ": " << (gap ? gap->in_words(2) : ""));
    CHECK(!gap);
  }
}
