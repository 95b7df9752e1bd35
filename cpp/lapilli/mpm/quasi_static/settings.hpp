#pragma once

#include <array>
#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/mpm/shape_function.hpp"

namespace lapilli {

/// What a wall holds: all motion, motion along its normal, or motion along its face.
enum class WallKind { fixed, roller, tangent };

template <>
struct Names<WallKind> {
  static constexpr std::pair<WallKind, const char*> values[] = {
      {WallKind::fixed, "fixed"}, {WallKind::roller, "roller"}, {WallKind::tangent, "tangent"}};
};

/// How a wall that does not fit the grid is imposed.
/// pointwise: stiffly at every point of the wall, with the wall's traction (the paper);
/// mean_gap: stiffly on the mean over each cut cell, moderately at every point; no locking;
/// nitsche: moderately at every point, with the wall's traction;
/// penalty: stiffly at every point, without the wall's traction.
enum class WallForm { pointwise, mean_gap, nitsche, penalty };

template <>
struct Names<WallForm> {
  static constexpr std::pair<WallForm, const char*> values[] = {{WallForm::pointwise, "pointwise"},
                                                                {WallForm::mean_gap, "mean-gap"},
                                                                {WallForm::nitsche, "nitsche"},
                                                                {WallForm::penalty, "penalty"}};
};

/// A surface on which the displacement is prescribed.
struct WallSettings {
  std::string name;                   // "footing"; errors and reports use it
  WallKind kind = WallKind::fixed;
  std::vector<Vec3> line;             // m, 2D: open line of points, the material on its left
  std::array<Value, 3> displacement;  // m, of the wall since time 0: tables in time carry the wall
                                      // along; functions of place leave it where it stands

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("what errors and reports call it"), self.name);
    visit(Key("kind").text("fixed, roller (free along its face) or tangent (free along its normal)"),
          self.kind);
    visit(Key("line").unit("m").text("2D: points of an open line, the material on its left"),
          self.line);
    visit(Key("displacement").unit("m").text("of the wall since time 0, one value an axis"),
          self.displacement);
  }
};

/// A surface on which a traction acts. It does not follow the material.
struct TractionSettings {
  std::string name;
  std::vector<Vec3> line;         // m, 2D: open line of points, the material on its left
  std::array<Value, 3> traction;  // Pa, in the directions of the axes

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("what errors and reports call it"), self.name);
    visit(Key("line").unit("m").text("2D: points of an open line, the material on its left"),
          self.line);
    visit(Key("traction").unit("Pa").text("force per area, one value an axis"), self.traction);
  }
};

/// Equilibrium under load steps, solved implicitly on the background grid.
struct QuasiStaticSettings {
  ShapeFunction shape_function = ShapeFunction::gimp;  // linear or gimp
  WallForm wall_form = WallForm::mean_gap;
  double bandwidth = 1e-3;            // cells; stiff constraint: 4/(3 bandwidth) moduli per cell
  double gap_bandwidth = 0.05;        // cells; moderate constraint of mean-gap and nitsche
  double ghost = 0.01;                // ghost stabilisation of cut and surface cells; 0: none
  bool hold_empty_cells = true;       // a wall in an empty cell next to material keeps its hold
  double largest_penetration = 0.5;   // cells; a point further behind a wall fails the load step
  std::array<Value, 3> body_force;    // N/m3
  double tolerance = 1e-10;           // of the out-of-balance force, relative
  int largest_iterations = 12;        // of Newton's method in one load step
  int largest_halvings = 6;           // of a load step that fails
  std::vector<WallSettings> walls;
  std::vector<TractionSettings> tractions;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("shape_function").text("linear or gimp"), self.shape_function);
    visit(Key("wall_form").text("pointwise, mean-gap, nitsche or penalty"), self.wall_form);
    visit(Key("bandwidth").unit("cells").range(0.0, 1.0, true).text("of the stiff constraint"),
          self.bandwidth);
    visit(Key("gap_bandwidth").unit("cells").range(0.0, 1.0, true).text(
              "of the moderate constraint of mean-gap and nitsche"),
          self.gap_bandwidth);
    visit(Key("ghost").range(0.0, 1.0).text("stabilisation of cut cells"), self.ghost);
    visit(Key("hold_empty_cells").text("a wall in an empty cell next to material keeps its hold"),
          self.hold_empty_cells);
    visit(Key("largest_penetration").unit("cells").positive().text(
              "a point further behind a wall fails the load step"),
          self.largest_penetration);
    visit(Key("body_force").unit("N/m3").text("one value an axis"), self.body_force);
    visit(Key("tolerance").range(0.0, 1e-2, true).text("of the out-of-balance force, relative"),
          self.tolerance);
    visit(Key("largest_iterations").range(1, 1000).text("of Newton's method in one load step"),
          self.largest_iterations);
    visit(Key("largest_halvings").range(0, 30).text("of a load step that fails"),
          self.largest_halvings);
    visit(Key("walls").text("where the displacement is prescribed"), self.walls);
    visit(Key("tractions").text("where forces act on the surface"), self.tractions);
  }
};

}  // namespace lapilli
