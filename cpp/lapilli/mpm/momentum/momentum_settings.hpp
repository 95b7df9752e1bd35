#pragma once

#include <array>
#include <utility>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/vector.hpp"

namespace lapilli {

/// What points and nodes hand each other of the velocity.
enum class VelocityTransfer {
  flip,  // increments, with `pic_share` of the nodal velocity
  apic,  // affine, keeps angular momentum (Jiang et al. 2015)
  tpic   // affine by the velocity gradient
};

template <>
struct Names<VelocityTransfer> {
  static constexpr std::pair<VelocityTransfer, const char*> values[] = {
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

/// How a face of the grid holds the material.
enum class WallKind {
  open,       // no wall: a point that passes stops the run
  no_slip,    // sticks
  roller,     // slides freely, cannot part
  frictional  // parts freely, slides with Coulomb friction
};

template <>
struct Names<WallKind> {
  static constexpr std::pair<WallKind, const char*> values[] = {
      {WallKind::open, "open"},
      {WallKind::no_slip, "no_slip"},
      {WallKind::roller, "roller"},
      {WallKind::frictional, "frictional"}};
};

/// One face of the grid.
struct Wall {
  WallKind kind = WallKind::open;
  double friction = 0.0;  // coefficient, of a frictional wall

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("kind").text("open, no_slip, roller or frictional"), self.kind);
    visit(Key("friction").non_negative().text("Coulomb coefficient of a frictional wall"),
          self.friction);
  }
};

/// Explicit momentum on material points.
struct MomentumSettings {
  Vec3 gravity = Vec3::Zero();  // m/s2
  VelocityTransfer transfer = VelocityTransfer::flip;
  double pic_share = 0.05;  // of FLIP, in [0, 1]
  StressUpdate stress_update = StressUpdate::musl;
  double step_safety = 0.5;        // automatic step over h / (wave speed + point speed), in (0, 1]
  std::array<Wall, 6> walls = {};  // x lower, x upper, y lower, y upper, z lower, z upper

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("gravity").unit("m/s2").text("acceleration of every point"), self.gravity);
    visit(Key("transfer").text("flip, apic or tpic"), self.transfer);
    visit(Key("pic_share").range(0.0, 1.0).text("share of the nodal velocity in FLIP"),
          self.pic_share);
    visit(Key("stress_update").text("usl or musl"), self.stress_update);
    visit(Key("step_safety")
              .range(0.0, 1.0, true)
              .text("automatic step over h / (wave speed + point speed)"),
          self.step_safety);
    static constexpr const char* names[] = {"wall_x_lower", "wall_x_upper", "wall_y_lower",
                                            "wall_y_upper", "wall_z_lower", "wall_z_upper"};
    for (std::size_t face = 0; face < 6; ++face) {
      visit(Key(names[face]).text("how this face of the grid holds the material"),
            self.walls[face]);
    }
  }
};

/// Throws std::invalid_argument naming the first setting outside its range.
void check(const MomentumSettings& settings);

}  // namespace lapilli
