#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// How an obstacle resists what slides along it.
enum class ObstacleContact { frictional, slip, no_slip };

template <>
struct Names<ObstacleContact> {
  static constexpr std::pair<ObstacleContact, const char*> values[] = {
      {ObstacleContact::frictional, "frictional"},
      {ObstacleContact::slip, "slip"},
      {ObstacleContact::no_slip, "no_slip"}};
};

/// A rigid obstacle of any shape: terrain, a tool, a box, at rest or with a prescribed motion; with
/// a mass, a body that its weight and the forces on it move. It need not fit the grid.
struct Obstacle {
  std::string name;
  Shape shape;
  ObstacleContact contact = ObstacleContact::frictional;
  double friction = 0.0;                    // coefficient of Coulomb friction
  double adhesion = 0.0;                    // Pa of shear on top of it, while in contact
  bool separation = true;                   // whether material that has touched it may part
  std::vector<double> velocity;             // m/s; empty: none
  double revolutions_per_second = 0.0;      // 1/s, positive counter-clockwise
  std::vector<double> center;               // m, of the turning, at the start; empty: the origin
  std::vector<double> axis{0.0, 0.0, 1.0};  // of the turning, 3D only
  Value factor = 1.0;                       // multiplies both motions: a number or a table in time
  std::optional<double> mass;     // kg (per metre of depth in 2D), of one that moves freely
  std::vector<double> inertia;    // kg m2 about its centre: one number in 2D, about x, y, z in 3D
  std::vector<Value> force;       // N, besides weight and contacts; empty: none
  std::vector<std::string> held;  // of a free one: x, y, z, rotation go on as they start
  std::optional<Value> temperature;     // K, of its surface; absent: no heat passes
  std::optional<Value> conductance;     // W/(m^2 K), of the contact; absent: perfect
  std::optional<double> heat_capacity;  // J/K (per metre of depth in 2D), of one that heat warms

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name of the obstacle in diagnostics and messages"), self.name);
    visit(Key("shape").required().text("what material cannot enter, any shape"), self.shape);
    visit(Key("contact").text("frictional, slip or no_slip"), self.contact);
    visit(Key("friction").non_negative().text("coefficient of Coulomb friction, of frictional"),
          self.friction);
    visit(Key("adhesion").unit("Pa").non_negative().text("shear it bears beyond friction"),
          self.adhesion);
    visit(Key("separation")
              .text("whether material that has touched it may part from it; else it can pull"),
          self.separation);
    visit(Key("velocity")
              .unit("m/s")
              .length(0, 3)
              .text("one number an axis, with a mass at the start; empty: none"),
          self.velocity);
    visit(Key("revolutions_per_second")
              .unit("1/s")
              .text("positive counter-clockwise, with a mass at the start"),
          self.revolutions_per_second);
    visit(Key("center").unit("m").length(0, 3).text(
              "centre of the turning; empty: the origin, with a mass the centre of the shape"),
          self.center);
    visit(Key("axis").length(3, 3).text("direction of the axis, in 3D"), self.axis);
    visit(Key("factor").text("multiplies the motion: a number or a table in time"), self.factor);
    visit(Key("mass").unit("kg").positive().text(
              "of one that its weight and the forces on it move, in 2D per metre of depth; absent: "
              "its motion is prescribed"),
          self.mass);
    visit(Key("inertia").unit("kg m^2").length(0, 3).text(
              "about its centre, one number in 2D, about x, y, z in 3D; empty: of the shape at one "
              "density"),
          self.inertia);
    visit(Key("force").unit("N").length(0, 3).text(
              "on one with a mass, besides weight and contacts, one value an axis; empty: none"),
          self.force);
    visit(Key("held").text(
              "of one with a mass: \"x\", \"y\", \"z\", \"rotation\" that go on as at the start"),
          self.held);
    visit(Key("temperature")
              .unit("K")
              .text("of its surface, a number or a table in time; absent: no heat passes"),
          self.temperature);
    visit(Key("conductance")
              .unit("W/(m^2 K)")
              .non_negative()
              .absent("perfect")
              .text("thermal contact conductance where material touches it: flux over the jump of "
                    "the temperature, a number or a table in time"),
          self.conductance);
    visit(Key("heat_capacity")
              .unit("J/K")
              .positive()
              .text("of one that the heat it takes warms, from its temperature on, in 2D per metre "
                    "of depth; absent: its temperature stays as given"),
          self.heat_capacity);
  }
};

/// What it is called where it has no name of its own: by its place among all.
std::string name_of(const Obstacle& obstacle, std::size_t index);

/// Throws std::invalid_argument naming the first number of obstacle `index` out of range. Prepares
/// its shape for queries.
void check(const Obstacle& obstacle, int dimension, int index);

}  // namespace lapilli
