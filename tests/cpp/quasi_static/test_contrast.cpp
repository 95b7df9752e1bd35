// Stiff and soft bodies in one scene: right, or refused with a sentence.
#include <catch2/catch.hpp>

#include "lapilli/core/require.hpp"
#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;
using Catch::Matchers::Contains;

namespace {

struct Answer {
  double end = 0.0;  // displacement of the free end
  std::string refusal;
};

/// Two bars of 4 x 2.4 in a row, the first held at its left end, pulled at the right end of the
/// second; no Poisson effect, so that the displacement is straight in each.
Answer pull(double first, double second, double load, double cell) {
  Points points(2);
  const Grid<2> grid(Vec<2>(-2.0, -2.0), Vec<2>(11.0, 5.0), cell);
  fill_clipped(points, grid, Box{{0.3, 0.3}, {4.3, 2.7}}, 2);
  const FilledPoints other = [&] {
    FillOptions options;
    options.clip = true;
    options.smallest_volume = 0.0;
    return fill(Box{{4.3, 0.3}, {8.3, 2.7}}, Lattice{Vec3(-2.0, -2.0, 0.0), cell, 2}, options, 2);
  }();
  points.append(other.position, other.volume, 1);
  QuasiStaticSettings settings;
  settings.supports = {{"left", HeldMotion::fixed, {{}, false, {{0.3, 2.7}, {0.3, 0.3}}, {}}, {}}};
  settings.tractions = {{"pull", {{}, false, {{8.3, 0.3}, {8.3, 2.7}}, {}}, {load, 0.0}}};
  try {
    QuasiStatic<2> physics(points, grid, ShapeFunction::linear,
                           {LinearElastic{1e-9, first, 0.0}, LinearElastic{1e-9, second, 0.0}},
                           settings);
    physics.advance({0.0, 1.0, 0});
    double far = 0.0;
    for (Index p = 0; p < points.size(); ++p) {
      far = std::max(far, physics.displacement()[2 * p]);
    }
    return {far, ""};
  } catch (const std::exception& error) {
    return {0.0, error.what()};
  }
}

}  // namespace

TEST_CASE("stiff beside soft: within 4 % up to 1e8, refused or right beyond") {
  // The interface lies inside a cell, whose one strain both bars share: 0.3 of a cell each at most.
  for (const double contrast : {1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14}) {
    for (const bool soft_first : {true, false}) {
      const double stiff = 1e3, soft = stiff / contrast, load = 1e-6 * soft;
      const Answer answer = pull(soft_first ? soft : stiff, soft_first ? stiff : soft, load, 0.1);
      const double exact = load * 4.0 * (1.0 / stiff + 1.0 / soft);
      INFO("contrast " << contrast << (soft_first ? ", soft first: " : ", stiff first: ")
                       << answer.end << " for " << exact << "; " << answer.refusal);
      if (contrast <= 1e8) {
        CHECK(answer.end == Approx(exact).epsilon(0.04));
      } else if (answer.refusal.empty()) {
        CHECK(answer.end == Approx(exact).epsilon(0.04));
      } else {
        CHECK_THAT(answer.refusal, Contains("youngs_modulus"));
      }
    }
  }
}
