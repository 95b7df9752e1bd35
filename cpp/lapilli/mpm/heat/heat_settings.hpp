#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/mpm/heat/conditions/heat_boundary.hpp"
#include "lapilli/mpm/heat/heat_contact.hpp"

namespace lapilli {

/// The unit of all temperatures of a scene; it matters where surfaces radiate.
enum class TemperatureUnit { kelvin, celsius };

template <>
struct Names<TemperatureUnit> {
  static constexpr std::pair<TemperatureUnit, const char*> values[] = {
      {TemperatureUnit::kelvin, "kelvin"}, {TemperatureUnit::celsius, "celsius"}};
};

/// How a flux law reaches the nodes.
enum class FluxMethod {
  virtual_flux,  // nodal normals, A_I = n_I . sum V grad S: the default
  paper,         // Yu & Zhao 2026, Algorithm 1: particle normals, volume-fraction surface
  particle,      // PB: the law acts on the outermost layer of points
  node           // NB: exact nodal areas; surfaces that lie on grid lines only
};

template <>
struct Names<FluxMethod> {
  static constexpr std::pair<FluxMethod, const char*> values[] = {
      {FluxMethod::virtual_flux, "virtual"},
      {FluxMethod::paper, "paper"},
      {FluxMethod::particle, "particle"},
      {FluxMethod::node, "node"}};
};

/// What points and nodes hand each other in a step.
enum class HeatTransfer {
  automatic,  // `nodal` where nothing moves, `affine` where points do
  nodal,      // nodal temperature stays between steps; points at rest only
  affine,     // affine FLIP with the step-scaled TPIC blend
  flip,
  pic,
  tpic
};

template <>
struct Names<HeatTransfer> {
  static constexpr std::pair<HeatTransfer, const char*> values[] = {
      {HeatTransfer::automatic, "auto"}, {HeatTransfer::nodal, "nodal"},
      {HeatTransfer::affine, "affine"},  {HeatTransfer::flip, "flip"},
      {HeatTransfer::pic, "pic"},        {HeatTransfer::tpic, "tpic"}};
};

/// How the nodal temperatures are advanced.
enum class TimeIntegration {
  automatic,       // explicit while that is cheaper, then implicit with steps from a tolerance
  explicit_euler,  //
  implicit_theta
};

template <>
struct Names<TimeIntegration> {
  static constexpr std::pair<TimeIntegration, const char*> values[] = {
      {TimeIntegration::automatic, "auto"},
      {TimeIntegration::explicit_euler, "explicit"},
      {TimeIntegration::implicit_theta, "implicit"}};
};

/// Linear solver of the theta scheme.
enum class HeatSolver { automatic, direct, conjugate_gradient };

template <>
struct Names<HeatSolver> {
  static constexpr std::pair<HeatSolver, const char*> values[] = {
      {HeatSolver::automatic, "auto"},
      {HeatSolver::direct, "direct"},
      {HeatSolver::conjugate_gradient, "cg"}};
};

/// Heat conduction: the section [heat] of a scene.
struct HeatSettings {
  FluxMethod method = FluxMethod::virtual_flux;
  HeatTransfer transfer = HeatTransfer::automatic;
  TimeIntegration time_integration = TimeIntegration::automatic;
  double theta = 0.5;       // 0.5 Crank-Nicolson, 1 backward Euler
  double tolerance = 1e-4;  // of "auto", relative to the span of temperatures
  HeatSolver solver = HeatSolver::automatic;
  std::optional<TemperatureUnit> unit;  // kelvin unless said
  double blend = 4.0;                   // c of beta = 1 - exp(-c dt alpha/h^2)
  int normal_smoothing = 2;             // passes of 1/4, 1/2, 1/4 before nodal normals
  double surface_fraction = 0.55;       // eta of the paper's surface rule
  bool implicit_robin = true;           // convection and radiation at the end of the step
  bool corner_fit = true;               // fitted vector at sharp corners
  std::optional<bool> subcycling;       // heat in steps of its own beside those of [dynamics]
  std::vector<HeatBoundary> boundaries;
  std::vector<HeatContact> contacts;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("method").text("how fluxes reach the nodes"), self.method);
    visit(Key("transfer").text("what points and nodes hand each other"), self.transfer);
    visit(Key("time_integration")
              .text("explicit Euler, the implicit theta scheme, or what costs least"),
          self.time_integration);
    visit(Key("tolerance")
              .range(1e-8, 0.1)
              .text("error of time integration \"auto\", as a share of the span of temperatures"),
          self.tolerance);
    visit(Key("theta").range(0.5, 1.0).text("implicitness of the theta scheme"), self.theta);
    visit(Key("solver").text("linear solver of the theta scheme"), self.solver);
    visit(Key("temperature_unit")
              .text("unit of all temperatures, kelvin unless said; radiation needs absolute ones"),
          self.unit);
    visit(Key("blend").range(0.0, 1e3).text("c of the step-scaled blend 1 - exp(-c dt alpha/h^2)"),
          self.blend);
    visit(Key("normal_smoothing").range(0, 16).text("smoothing passes before nodal normals"),
          self.normal_smoothing);
    visit(Key("surface_fraction")
              .range(0.0, 1.0, true)
              .text("volume fraction below which a cell is surface (method paper)"),
          self.surface_fraction);
    visit(
        Key("implicit_robin")
            .text(
                "take convection and radiation at the end of the step, stable for any coefficient"),
        self.implicit_robin);
    visit(Key("corner_fit").text("give sharp corners their whole area"), self.corner_fit);
    visit(Key("subcycling")
              .absent("auto")
              .text("one step of heat for several of [dynamics], or several for one; where the "
                    "clock chooses the step and transfer is affine or flip when not given"),
          self.subcycling);
    visit(
        Key("boundaries")
            .text("fluxes and prescribed temperatures; the first region that covers a place wins"),
        self.boundaries);
    visit(Key("contacts").text("where bodies that touch resist the heat between them"),
          self.contacts);
  }
};

}  // namespace lapilli
