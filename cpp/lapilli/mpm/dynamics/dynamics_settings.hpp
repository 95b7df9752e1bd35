#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/note.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/dynamics/contacts/body_contact.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacle.hpp"

namespace lapilli {

/// What points and nodes hand each other of the velocity.
enum class VelocityTransfer {
  blended_apic,  // affine increments that fade at the rate of deformation, `blend_rate`
  flip,          // increments, with `pic_fraction` of the nodal velocity a step
  apic,          // affine, keeps angular momentum (Jiang et al. 2015)
  tpic           // affine by the velocity gradient
};

template <>
struct Names<VelocityTransfer> {
  static constexpr std::pair<VelocityTransfer, const char*> values[] = {
      {VelocityTransfer::blended_apic, "blended_apic"},
      {VelocityTransfer::flip, "flip"},
      {VelocityTransfer::apic, "apic"},
      {VelocityTransfer::tpic, "tpic"}};
};

/// Which nodal velocity strains the points at the end of a step.
enum class StressUpdate {
  usl,  // the one that was solved for
  musl  // the updated point velocities projected once more: steady where nodes carry little mass
};

template <>
struct Names<StressUpdate> {
  static constexpr std::pair<StressUpdate, const char*> values[] = {{StressUpdate::usl, "usl"},
                                                                    {StressUpdate::musl, "musl"}};
};

/// What becomes of a point that leaves the grid.
enum class Outside {
  stop,   // the run ends with an error
  remove  // the point is taken out, with all that it carries
};

template <>
struct Names<Outside> {
  static constexpr std::pair<Outside, const char*> values[] = {{Outside::stop, "stop"},
                                                               {Outside::remove, "remove"}};
};

/// A face of the grid.
enum class GridFace { x_lower, x_upper, y_lower, y_upper, z_lower, z_upper };

template <>
struct Names<GridFace> {
  static constexpr std::pair<GridFace, const char*> values[] = {
      {GridFace::x_lower, "x_lower"}, {GridFace::x_upper, "x_upper"},
      {GridFace::y_lower, "y_lower"}, {GridFace::y_upper, "y_upper"},
      {GridFace::z_lower, "z_lower"}, {GridFace::z_upper, "z_upper"}};
};

/// A face of the grid that the material sticks to.
struct NoSlipBoundary {
  static constexpr const char* kind = "no_slip";
  GridFace face = GridFace::y_lower;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("face").required().text("x_lower, x_upper, y_lower, y_upper, z_lower or z_upper"),
          self.face);
  }
};

/// A face that the material slides along freely and cannot part from.
struct RollerBoundary {
  static constexpr const char* kind = "roller";
  GridFace face = GridFace::y_lower;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    NoSlipBoundary::describe(self, visit);
  }
};

/// A face that the material parts from freely and slides along with Coulomb friction.
struct FrictionalBoundary {
  static constexpr const char* kind = "frictional";
  GridFace face = GridFace::y_lower;
  double coefficient = 0.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    NoSlipBoundary::describe(self, visit);
    visit(Key("coefficient").non_negative().text("tangent of the angle of wall friction"),
          self.coefficient);
  }
};

using GridBoundary = std::variant<NoSlipBoundary, RollerBoundary, FrictionalBoundary>;

/// A pressure on a free surface.
struct Pressure {
  static constexpr const char* kind = "pressure";
  std::string name;
  Value value;                  // Pa, positive pushes into the body
  std::optional<Shape> region;  // the surface inside this shape; all that is left when absent

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name of the region in balance and messages"), self.name);
    visit(Key("value").unit("Pa").required().text("pressure, positive into the body"), self.value);
    visit(Key("region").text("shape that selects the surface"), self.region);
  }
};

/// A force per area of a free surface.
struct Traction {
  static constexpr const char* kind = "traction";
  std::string name;
  std::vector<double> value;  // Pa, one number an axis
  Value factor = 1.0;         // multiplies it: constant, tabulated in time or a function
  std::optional<Shape> region;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name of the region in balance and messages"), self.name);
    visit(
        Key("value").unit("Pa").required().length(2, 3).text("force per area, one number an axis"),
        self.value);
    visit(Key("factor").text("multiplies it: a number, a table in time or a function"),
          self.factor);
    visit(Key("region").text("shape that selects the surface"), self.region);
  }
};

using DynamicsBoundary = std::variant<Pressure, Traction>;

/// Explicit dynamics on material points: the section [dynamics] of a scene. Faces of the grid
/// without a wall are open: a point that passes one stops the run, or is removed.
struct DynamicsSettings {
  std::vector<double> gravity;          // m/s^2, one number an axis; empty: none
  Value gravity_factor = 1.0;           // multiplies it: a number or a table in time
  double local_damping = 0.0;           // share of the force out of balance, against the velocity
  std::optional<double> damping_until;  // s; to the end of the run where absent
  VelocityTransfer transfer = VelocityTransfer::blended_apic;
  double blend_rate = 4.0;     // of blended_apic, a unit of strain; at least 0
  double pic_fraction = 0.05;  // of FLIP, a step; in [0, 1]
  StressUpdate stress_update = StressUpdate::musl;
  std::optional<bool> b_bar;  // the dilatation of a cell is the mean over its points
  double courant = 0.5;       // automatic step over h / (wave speed + point speed), in (0, 1]
  std::vector<GridBoundary> grid_boundaries;
  Outside outside = Outside::stop;
  std::vector<Obstacle> obstacles;
  std::vector<BodyContact> contacts;
  std::vector<DynamicsBoundary> boundaries;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("gravity").unit("m/s^2").length(0, 3).text("one number an axis; empty: none"),
          self.gravity);
    visit(Key("gravity_factor").text("multiplies gravity: a number or a table in time"),
          self.gravity_factor);
    visit(Key("local_damping")
              .range(0.0, 0.95)
              .text("share of the force out of balance that acts against the velocity, for a "
                    "static start"),
          self.local_damping);
    visit(Key("damping_until")
              .unit("s")
              .non_negative()
              .text("when local damping ends; absent: with the run"),
          self.damping_until);
    visit(Key("transfer").text("what points and nodes hand each other"), self.transfer);
    visit(
        Key("blend_rate")
            .non_negative()
            .text(
                "blended_apic: rate, per unit of strain, at which points take the nodal velocity"),
        self.blend_rate);
    visit(Key("pic_fraction")
              .range(0.0, 1.0)
              .text("flip: share of the nodal velocity, applied once a step"),
          self.pic_fraction);
    visit(Key("stress_update").text("which nodal velocity strains the points"), self.stress_update);
    visit(Key("b_bar").absent("auto").text(
              "points take the mean dilatation of their cell, so that it does not lock; absent: "
              "those of a Poisson ratio above 0.4, or whose strength does not grow with pressure"),
          self.b_bar);
    visit(Key("courant")
              .range(0.0, 1.0, true)
              .text("automatic step over h / (wave speed + point speed)"),
          self.courant);
    visit(Key("grid_boundaries").text("faces of the grid that hold the material; others are open"),
          self.grid_boundaries);
    visit(
        Key("outside").text("what becomes of points that leave through open faces: the run stops, "
                            "or they are removed with all that they carry"),
        self.outside);
    visit(Key("obstacles").text("rigid shapes that material cannot enter, at rest or moving"),
          self.obstacles);
    visit(Key("contacts").text("what pairs of bodies do where they meet; others: see the manual"),
          self.contacts);
    visit(
        Key("boundaries").text("loads on free surfaces; the first region that covers a place wins"),
        self.boundaries);
  }
};

/// Throws std::invalid_argument naming the first setting outside its range.
void check(const DynamicsSettings& settings, int dimension);

/// What is allowed and makes the answer depend on the numerics, a sentence each.
std::vector<Note> warnings(const DynamicsSettings& settings);

}  // namespace lapilli
