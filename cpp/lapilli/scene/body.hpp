#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/prescribed_motion.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/materials/coupling.hpp"
#include "lapilli/materials/newtonian.hpp"
#include "lapilli/materials/solid.hpp"
#include "lapilli/materials/thermal.hpp"
#include "lapilli/mpm/dynamics/geostatic.hpp"

namespace lapilli {

/// What a body is made of; each physics takes the one it knows.
using Material =
    Joined<std::variant<Thermal, Newtonian, ThermalExpansion, PlasticHeating>, Solid>::type;

/// How a shape is filled with points: each with the volume and the centroid of its part of the
/// shape, or whole boxes of a lattice whose middles lie inside, as in the papers.
enum class Filling { exact, lattice };

template <>
struct Names<Filling> {
  static constexpr std::pair<Filling, const char*> values[] = {{Filling::exact, "exact"},
                                                               {Filling::lattice, "lattice"}};
};

/// Points handed over by a program; no file holds them.
struct GivenPoints {
  std::vector<double> positions;  // m, rows x dimension
  std::vector<double> volumes;    // m^dimension
};

/// A body: where its points come from, what it is made of, how it starts and how it is moved.
/// Points come from one of `shape`, `points_file`, `points`.
struct Body {
  std::string name;
  std::optional<Shape> shape;
  std::string points_file;                        // text rows: coordinates, volume
  std::optional<GivenPoints> points;              // from a program only
  std::optional<int> points_per_cell;             // automatic: two along each axis
  std::optional<Filling> fill;                    // automatic: see is_filled_exactly
  double jitter = 0.0;                            // of the points' spacing
  bool random = false;                            // anywhere in their cell instead of a lattice
  Index seed = 1;                                 // of jitter and random
  double rotation = 0.0;                          // degree, of the filled points
  std::vector<double> rotation_center;            // m; empty: the origin
  std::vector<double> rotation_axis = {0, 0, 1};  // three dimensions only
  std::vector<double> translation;                // m, after the rotation; empty: none
  std::vector<Material> material;
  Value temperature = 0.0;                // K, at the start
  Value source = 0.0;                     // W/m^3, heat released
  std::vector<double> velocity;           // m/s, at the start; empty: at rest
  std::vector<double> spin, spin_center;  // rad/s; m
  std::optional<GeostaticStress> geostatic;
  std::optional<Motion> motion;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name in messages and results"), self.name);
    visit(Key("shape").text("shape filled with points"), self.shape);
    visit(Key("points_file").file().text("text file of points: coordinates and volume in each row"),
          self.points_file);
    visit(Key("points").text("arrays of points, from a program only"), self.points);
    visit(Key("points_per_cell")
              .range(1, 1000)
              .absent("auto")
              .text("points in a full cell, the same number along each axis"),
          self.points_per_cell);
    visit(Key("fill").absent("auto").text(
              "points with the volume of their part of the shape, or whole boxes of a lattice; "
              "automatic: lattice in peridynamic flow and under conditions on the surface of gimp "
              "points that may move, otherwise exact"),
          self.fill);
    visit(Key("jitter").range(0.0, 0.5).text("random displacement, in spacings of the points"),
          self.jitter);
    visit(Key("random").text("points anywhere in the shape instead of on a lattice"), self.random);
    visit(Key("seed").non_negative().text("seed of jitter and random"), self.seed);
    visit(Key("rotation").unit("degree").text("turn of the filled points, counter-clockwise"),
          self.rotation);
    visit(Key("rotation_center").unit("m").length(0, 3).text("point that stays; empty: the origin"),
          self.rotation_center);
    visit(Key("rotation_axis").length(3, 3).text("direction that stays, in three dimensions"),
          self.rotation_axis);
    visit(Key("translation").unit("m").length(0, 3).text("displacement after the turn"),
          self.translation);
    visit(Key("material")
              .required()
              .one_or_many()
              .length(1, 16)
              .text("what it is made of: one material, or one for each physics"),
          self.material);
    visit(Key("temperature").unit("K").text("temperature at the start"), self.temperature);
    visit(Key("source").unit("W/m^3").text("heat released in its volume"), self.source);
    visit(Key("velocity").unit("m/s").length(0, 3).text("velocity at the start"), self.velocity);
    visit(Key("spin").unit("rad/s").one_or_many().length(0, 3).text(
              "angular velocity at the start, counter-clockwise: a number, or x, y, z in space"),
          self.spin);
    visit(Key("spin_center")
              .unit("m")
              .length(0, 3)
              .text("place about which it spins; empty: the centre of its volume"),
          self.spin_center);
    visit(Key("geostatic").text("stress at the start, of a body at rest; absent: none"),
          self.geostatic);
    visit(Key("motion").text("prescribed motion"), self.motion);
  }
};

/// The material of this kind that a body is made of; nullptr without one.
template <class Wanted>
const Wanted* material_in(const Body& body) {
  for (const Material& one : body.material) {
    if (const auto* wanted = std::get_if<Wanted>(&one)) {
      return wanted;
    }
  }
  return nullptr;
}

/// The solids that a body is made of: one, where mechanics move it.
std::vector<Solid> solids_in(const Body& body);

}  // namespace lapilli
