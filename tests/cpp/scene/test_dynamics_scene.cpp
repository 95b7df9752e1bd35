#include <catch2/catch.hpp>
#include <set>

#include "lapilli/scene/build.hpp"
#include "lapilli/scene/check.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "scene/example_scenes.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

constexpr const char* start = R"(
[grid]
lower = [0.0, 0.0]
upper = [2.0, 1.0]
cell = 0.1
[[bodies]]
shape = {kind = "box", lower = [0.0, 0.0], upper = [0.5, 0.8]}
)";
constexpr const char* soil = R"(
[[bodies.material]]
kind = "mohr_coulomb"
density = 2000.0
youngs_modulus = 1e6
poissons_ratio = 0.3
friction_angle = 30.0
)";
constexpr const char* warm = R"(
[[bodies.material]]
kind = "thermal"
density = 2000.0
specific_heat = 1e-3
conductivity = 1.0
)";
constexpr const char* coupling = R"(
[[bodies.material]]
kind = "thermal_expansion"
coefficient = 1e-5
[[bodies.material]]
kind = "plastic_heating"
)";
constexpr const char* dynamics = R"(
[dynamics]
gravity = [0.0, -9.81]
[[dynamics.grid_boundaries]]
kind = "frictional"
face = "y_lower"
coefficient = 0.4
[[dynamics.grid_boundaries]]
kind = "roller"
face = "x_lower"
)";
constexpr const char* heat = R"(
[[heat.boundaries]]
kind = "convection"
coefficient = 1.0
ambient = 1.0
)";
constexpr const char* end = "[time]\nend = 0.2\n";

std::string text_of_parts(const std::vector<const char*>& parts) {
  std::string text;
  for (const char* part : parts) {
    text += part;
  }
  return text;
}

/// The arrays with a row a point that a scene keeps, as its checkpoint names them.
std::set<std::string> point_arrays(const std::string& text) {
  const auto simulation = build(parse_scene(text, "soil.toml"));
  simulation->step();
  Archive archive;
  simulation->save(archive);
  std::set<std::string> names;
  for (const auto& [name, array] : archive.arrays()) {
    const auto* numbers = std::get_if<std::vector<double>>(&array);
    if (numbers != nullptr && static_cast<Index>(numbers->size()) >= simulation->points().size() &&
        !name.starts_with("points/")) {
      names.insert(name);
    }
  }
  return names;
}

}  // namespace

TEST_CASE("a scene allocates the fields of its physics and no others") {
  using Names = std::set<std::string>;
  // The blended transfer keeps a gradient of the velocity, and the velocity that moved a point
  // last.
  const Names of_dynamics{"dynamics/mass",       "dynamics/velocity", "dynamics/stress",
                          "dynamics/affine",     "dynamics/carried",  "dynamics/opened",
                          "dynamics/strain_rate"};
  CHECK(point_arrays(text_of_parts({start, soil, dynamics, end})) == of_dynamics);
  Names of_heat = point_arrays(text_of_parts({start, warm, heat, end}));
  for (const std::string& name : of_heat) {
    CHECK_THAT(name, StartsWith("heat/"));
  }
  const Names both = point_arrays(text_of_parts({start, soil, warm, dynamics, heat, end}));
  CHECK(both.contains("heat/sub_cycle/change"));  // by which temperature goes on between its steps
  CHECK_FALSE(both.contains("dynamics/deformation"));
  CHECK_FALSE(both.contains("dynamics/plastic"));
  CHECK_FALSE(both.contains("dynamics/free_strain"));
  const Names coupled =
      point_arrays(text_of_parts({start, soil, warm, coupling, dynamics, heat, end}));
  CHECK(coupled.contains("dynamics/plastic"));
  CHECK(coupled.contains("dynamics/free_strain"));
  CHECK(coupled.size() == both.size() + 3);  // and the temperature that expansion last saw
}

TEST_CASE("heat on collapsing soil is kept, with plastic work and expansion") {
  const auto simulation =
      build(parse_scene(text_of_parts({start, soil, warm, coupling, dynamics, heat, end}), ""));
  simulation->run_until(simulation->end());
  const std::vector<Balance> balances = simulation->balances();
  CHECK(balances[0].quantity == "heat");
  CHECK(std::abs(balances[0].residual()) < 1e-10);
  REQUIRE(balances[0].entries.size() == 2);
  // 0.9 of what dynamics dissipated, but for the work of the last step.
  CHECK(balances[0].entries[1].in == Approx(-0.9 * balances[1].entries[0].in).epsilon(0.02));
}

TEST_CASE("mistakes of dynamics are named with their place") {
  struct Mistake {
    const char *from, *to, *message;
  };
  const auto mistake = GENERATE(
      Mistake{"friction_angle = 30.0", "friction_angle = 30.0\ndilatancy_angle = 40.0",
              "dilatancy_angle must lie between 0"},
      Mistake{"poissons_ratio = 0.3", "poissons_ratio = 0.5", "poissons_ratio"},
      Mistake{"poissons_ratio = 0.3", "poissons_ratio = -1.0", "poissons_ratio"},
      Mistake{"density = 2000.0", "density = 0.0", "density must be above 0"},
      Mistake{"face = \"x_lower\"", "face = \"z_lower\"", "no face z_lower"},
      Mistake{"face = \"x_lower\"", "face = \"y_lower\"", "two walls"},
      Mistake{"gravity = [0.0, -9.81]", "gravity = [0.0, -9.81, 0.0]", "2 numbers"},
      Mistake{"end = 0.2", "end = 0.2\nstep = 0.01", "above the limit of"},
      Mistake{"[[dynamics.grid_boundaries]]\nkind = \"roller\"\nface = \"x_lower\"",
              "[[dynamics.boundaries]]\nkind = \"traction\"\nvalue = [1.0, 0.0]\nregion = {kind = "
              "\"disk\", center = [1.5, 0.9], radius = 0.05}",
              "selects no surface"},
      Mistake{"[[dynamics.grid_boundaries]]\nkind = \"roller\"\nface = \"x_lower\"",
              "[[dynamics.boundaries]]\nkind = \"traction\"\nvalue = [1.0, 0.0, 0.0]", "2 numbers"},
      Mistake{"kind = \"mohr_coulomb\"\n", "kind = \"mohr_colomb\"\n", "mohr_coulomb"});
  const std::string whole = text_of_parts({start, soil, dynamics, end});
  const std::string said =
      error_of([&] { build(parse_scene(replaced(whole, mistake.from, mistake.to), "soil.toml")); });
  CAPTURE(mistake.to, said);
  CHECK_THAT(said, Contains(mistake.message));
  CHECK_THAT(said, StartsWith("soil.toml:"));
}

TEST_CASE("what bodies lack for dynamics is named") {
  const auto said = [](const std::vector<const char*>& parts) {
    return error_of([&] { build(parse_scene(text_of_parts(parts), "soil.toml")); });
  };
  CHECK_THAT(said({start, warm, dynamics, end}), Contains("which [dynamics] needs"));
  CHECK_THAT(said({start, soil, coupling, dynamics, end}), Contains("needs both [heat] and"));
  CHECK_THAT(said({start, "velocity = [1.0, 0.0]\n", warm, heat, end}),
             Contains("no effect without [dynamics]"));
  CHECK_THAT(said({start, "motion = {kind = \"translation\", velocity = [1.0, 0.0]}\n", soil,
                   dynamics, end}),
             Contains("contradicts [dynamics]"));
}

TEST_CASE("a report says that dynamics is modelled, and its walls") {
  const CheckReport report =
      check(parse_scene(text_of_parts({start, soil, dynamics, end}), "soil.toml"));
  const std::string text = text_of(report);
  CHECK_THAT(text, Contains("explicit dynamics in plane strain"));
  CHECK_THAT(text, Contains("frictional wall y_lower"));
  CHECK_THAT(text,
             Contains("a wave of") && Contains("may cross one cell") && !Contains("deformation"));
}

TEST_CASE("a report says which bodies have one dilatation a cell") {
  const auto report_with = [](const char* poisson) {
    std::string clay = soil;
    const std::string was = "poissons_ratio = 0.3";
    clay.replace(clay.find(was), was.size(), std::string("poissons_ratio = ") + poisson);
    return text_of(
        check(parse_scene(text_of_parts({start, clay.c_str(), dynamics, end}), "a.toml")));
  };
  CHECK_THAT(report_with("0.49"), Contains("one dilatation a cell (b_bar) in body"));
  CHECK_THAT(report_with("0.3"), !Contains("b_bar"));
}
