#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// What a wall holds: all motion, motion along its normal, or motion along its face.
enum class HeldMotion { fixed, roller, tangent };

template <>
struct Names<HeldMotion> {
  static constexpr std::pair<HeldMotion, const char*> values[] = {{HeldMotion::fixed, "fixed"},
                                                                  {HeldMotion::roller, "roller"},
                                                                  {HeldMotion::tangent, "tangent"}};
};

/// How a wall that does not fit the grid is imposed.
/// mean_gap: stiffly on the mean over each cut cell, moderately at every point; no locking;
/// pointwise: stiffly at every point of the wall, with the wall's traction (the paper);
/// literal: pointwise with the paper's bandwidth of 1e-6 cells and no ghost stabilisation;
/// nitsche: moderately at every point, with the wall's traction;
/// penalty: stiffly at every point, without the wall's traction.
enum class Enforcement { mean_gap, pointwise, literal, nitsche, penalty };

template <>
struct Names<Enforcement> {
  static constexpr std::pair<Enforcement, const char*> values[] = {
      {Enforcement::mean_gap, "mean-gap"},
      {Enforcement::pointwise, "pointwise"},
      {Enforcement::literal, "literal"},
      {Enforcement::nitsche, "nitsche"},
      {Enforcement::penalty, "penalty"}};
};

/// Where a wall or a traction is: the surface of a shape, or in two dimensions an open line.
struct SurfaceSettings {
  std::optional<Shape> shape;             // its surface
  bool inside = false;                    // the material is inside the shape, not outside
  std::vector<std::vector<double>> line;  // m, 2D: points in order, the material on the left
  std::optional<Shape> within;            // only the part of the surface in here

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("shape").text("shape whose surface it is"), self.shape);
    visit(Key("inside").text("whether the material is inside the shape, or outside"), self.inside);
    visit(Key("line").unit("m").text("2D: points of an open line, the material on its left"),
          self.line);
    visit(Key("within").text("the part of the surface that counts; absent: all of it"),
          self.within);
  }
};

/// A surface on which the displacement is prescribed. Surfaces of shapes end where they meet the
/// shape of another wall.
struct SupportSettings {
  std::string name;  // "footing"; errors and reports use it
  HeldMotion kind = HeldMotion::fixed;
  SurfaceSettings surface;
  std::vector<Value> displacement;  // m, one value an axis, from where it stands at time 0; numbers
                                    // and tables carry the wall along, functions of place leave it
  Value advance = 0.0;              // m, of the face into the material, along its normal

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name in messages and results"), self.name);
    visit(Key("kind").text("fixed, roller (free along its face) or tangent (free across it)"),
          self.kind);
    SurfaceSettings::describe(self.surface, visit);
    visit(Key("displacement")
              .unit("m")
              .length(0, 3)
              .text("of the support since time 0, one value an axis; empty: it stands"),
          self.displacement);
    visit(Key("advance").unit("m").text(
              "of the face along its normal into the material since time 0: a hole that widens"),
          self.advance);
  }
};

/// A surface on which a traction or a pressure acts. The material carries it along: it moves,
/// stretches and turns with the points. The surface of a shape counts where it lies on the surface
/// of a body; every part of a line does.
struct TractionSettings {
  std::string name;
  SurfaceSettings surface;
  std::vector<Value> traction;  // Pa, one value an axis; empty: none
  Value pressure = 0.0;         // Pa, along the normal into the material

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name in messages and results"), self.name);
    SurfaceSettings::describe(self.surface, visit);
    visit(Key("traction")
              .unit("Pa")
              .length(0, 3)
              .text("force per area on the material, one value an axis; empty: none"),
          self.traction);
    visit(Key("pressure").unit("Pa").text("force per area along the normal into the material"),
          self.pressure);
  }
};

/// Equilibrium under load steps, solved implicitly on the background grid. Small strains; linear
/// elastic bodies; plane strain in two dimensions.
struct QuasiStaticSettings {
  Enforcement enforcement = Enforcement::mean_gap;
  std::optional<double> bandwidth;      // cells, of the stiff constraint; 1e-3, literal 1e-6
  std::optional<double> gap_bandwidth;  // cells, of the moderate constraint: mean-gap and nitsche
  std::optional<double> ghost_penalty;  // stabilisation of cut and surface cells; 0.01, literal 0
  bool hold_empty_cells = true;         // a wall in an empty cell next to material keeps its hold
  std::optional<double> reset;       // cells a point moves before the grid is reset; 0.1, literal 0
  std::optional<double> relaxation;  // cells of motion that take up what a reset leaves; 0.5,
                                     // literal 0
  std::optional<bool> update_volumes;  // volumes follow the strain; literal: they stay
  std::optional<bool> b_bar;           // the dilatation of a cell is the mean over its points
  double max_penetration = 0.5;        // cells; a point further behind a wall fails the load step
  std::vector<Value> gravity;          // m/s^2, one value an axis; empty: none
  std::vector<Value> body_force;       // N/m^3, one value an axis
  bool has_weight() const { return !gravity.empty() || !body_force.empty(); }
  double tolerance = 1e-10;  // of the out-of-balance force, relative
  int max_iterations = 12;   // of Newton's method in one load step
  int max_cutbacks = 6;      // of a load step that fails
  std::vector<SupportSettings> supports;
  std::vector<TractionSettings> tractions;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("enforcement").text("how supports that do not fit the grid are imposed"),
          self.enforcement);
    visit(Key("bandwidth")
              .unit("cells")
              .range(0.0, 1.0, true)
              .text("of the stiff constraint; absent: 1e-3, literal 1e-6"),
          self.bandwidth);
    visit(
        Key("gap_bandwidth")
            .unit("cells")
            .range(0.0, 1.0, true)
            .text("of the moderate constraint of mean-gap and nitsche; absent: 0.05, mean-gap 0.5 "
                  "until a point has moved by half a cell"),
        self.gap_bandwidth);
    visit(Key("ghost_penalty")
              .range(0.0, 1.0)
              .text("stabilisation of cut and surface cells; absent: 0.01, literal none"),
          self.ghost_penalty);
    visit(Key("hold_empty_cells").text("supports in empty cells beside material still hold it"),
          self.hold_empty_cells);
    visit(Key("reset").unit("cells").range(0.0, 1.0).text(
              "points keep their shape functions until one has moved this far; absent: 0.1, "
              "literal 0"),
          self.reset);
    visit(
        Key("relaxation")
            .unit("cells")
            .range(0.0, 100.0)
            .text("forces that a reset of the grid leaves out of balance are taken up while points "
                  "move this far; absent: 0.5, literal 0 (at once)"),
        self.relaxation);
    visit(Key("update_volumes")
              .absent("auto")
              .text("volumes of points follow their strain at each reset of the grid; absent: "
                    "yes, literal no"),
          self.update_volumes);
    visit(Key("b_bar").absent("auto").text(
              "points take the mean dilatation of their cell, so that it does not lock; absent: "
              "those of a Poisson ratio above 0.4"),
          self.b_bar);
    visit(Key("max_penetration")
              .unit("cells")
              .positive()
              .text("a point further behind a support fails the load step"),
          self.max_penetration);
    visit(Key("gravity").unit("m/s^2").length(0, 3).text(
              "acts on the density of every body, one value an axis; empty: none"),
          self.gravity);
    visit(Key("body_force").unit("N/m^3").length(0, 3).text("force per volume, one value an axis"),
          self.body_force);
    visit(Key("tolerance").range(0.0, 1e-2, true).text("of the out-of-balance force, relative"),
          self.tolerance);
    visit(Key("max_iterations").range(1, 1000).text("of Newton's method in one load step"),
          self.max_iterations);
    visit(Key("max_cutbacks").range(0, 30).text("of a load step that fails"), self.max_cutbacks);
    visit(Key("supports").text("where the displacement is prescribed"), self.supports);
    visit(Key("tractions").text("where forces act on the surface"), self.tractions);
  }
};

}  // namespace lapilli
