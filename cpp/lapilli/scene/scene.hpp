#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/mpm/dynamics/dynamics_settings.hpp"
#include "lapilli/mpm/heat/heat_settings.hpp"
#include "lapilli/mpm/quasi_static/settings.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"
#include "lapilli/scene/body.hpp"
#include "lapilli/scene/peridynamics.hpp"
#include "lapilli/scene/stage.hpp"

namespace lapilli {

/// The background grid; its corners give the dimension of the scene.
struct GridSettings {
  std::vector<double> lower;  // m, 1 to 3 numbers
  std::vector<double> upper;  // m, as many, a whole number of cells away
  double cell = 0.0;          // m
  ShapeFunction shape_function = ShapeFunction::gimp;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("lower").unit("m").required().length(1, 3).text("corner with the least coordinates"),
          self.lower);
    visit(Key("upper").unit("m").required().length(1, 3).text(
              "corner with the largest coordinates, a whole number of cells away"),
          self.upper);
    visit(Key("cell").unit("m").positive().required().text("size of a cell"), self.cell);
    visit(Key("shape_function").text("shape function of the nodes"), self.shape_function);
  }
};

/// When the run ends and how its steps are chosen.
struct TimeSettings {
  double end = 0.0;            // s
  std::optional<double> step;  // s; not set: automatic
  std::optional<Index> steps;  // equal steps to the end, for scenes that no step limits

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("end").unit("s").positive().required().text("time at which the run ends"), self.end);
    visit(Key("step").unit("s").positive().absent("auto").text("size of a step"), self.step);
    visit(Key("steps").range(1, 1e12).text("number of equal steps to the end, instead of a size"),
          self.steps);
  }
};

/// A field that is recorded at one position, or at the material point that is nearest to it at the
/// start, into the history of the run.
struct ProbeSettings {
  std::string name;
  std::vector<double> position;  // m
  bool material_point = false;   // whether it travels with the material
  std::string field = "temperature";
  std::optional<double> every;       // s; not set: with the rest of the history
  std::optional<Index> every_steps;  // instead

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").required().text("name of its column in the history"), self.name);
    visit(Key("position").unit("m").required().length(1, 3).text("where it is, inside a body"),
          self.position);
    visit(Key("material_point")
              .text("follow the material point nearest to the position at the start, instead of "
                    "staying there"),
          self.material_point);
    visit(Key("field").text("field of the output, or position"), self.field);
    visit(Key("every").unit("s").positive().text(
              "least time between records; with the rest of the history when not given"),
          self.every);
    visit(Key("every_steps").range(1, 1e12).text("steps between records, instead of a time"),
          self.every_steps);
  }
};

/// How the numbers of fields are stored in frames.
enum class Precision { full, single };

template <>
struct Names<Precision> {
  static constexpr std::pair<Precision, const char*> values[] = {{Precision::full, "double"},
                                                                 {Precision::single, "single"}};
};

/// What a run leaves on disk.
struct OutputSettings {
  std::string path;                  // frames for ParaView, ends in .vtkhdf; empty: none
  std::optional<double> every;       // s between frames; not set: the first and the last
  std::optional<Index> every_steps;  // steps between frames, instead
  std::optional<std::vector<std::string>> fields;  // of frames; not set: every field
  Precision precision = Precision::full;           // of the fields of frames
  Index compression = 0;                           // of frames; 0: none
  std::optional<double> history_every;     // s between rows of the history; not set: every frame
  bool checkpoint = true;                  // beside the frames, to resume from
  std::optional<double> checkpoint_every;  // s of wall time; not set: with every frame

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("path").text("file of frames for ParaView, ending in .vtkhdf"), self.path);
    visit(Key("every").unit("s").positive().text(
              "time between frames; the first and the last only when not given"),
          self.every);
    visit(Key("every_steps").range(1, 1e12).text("steps between frames, instead of a time"),
          self.every_steps);
    visit(Key("fields").text(
              "names of the fields that frames hold beside position, id, body and volume; every "
              "field when not given"),
          self.fields);
    visit(Key("precision")
              .text("of the fields of frames: eight bytes a number, or four with 7 digits; "
                    "positions and checkpoints always have eight"),
          self.precision);
    visit(Key("compression").range(0, 9).text("of frames, without loss: 0 none, 1 fast, 9 small"),
          self.compression);
    visit(Key("history_every")
              .unit("s")
              .positive()
              .text("least time between rows of the history; one with every frame when not given"),
          self.history_every);
    visit(Key("checkpoint").text("keep a state to resume from beside the frames"), self.checkpoint);
    visit(Key("checkpoint_every")
              .unit("s")
              .positive()
              .text("wall time between checkpoints; one with every frame when not given"),
          self.checkpoint_every);
  }
};

struct Places;

/// All that a run computes, as plain data. A section that is absent is physics that is not
/// modelled.
struct Scene {
  std::string title;
  GridSettings grid;
  std::string initial_state;  // checkpoint of the run that bodies go on from; empty: none
  std::vector<Body> bodies;
  std::optional<HeatSettings> heat;
  std::optional<DynamicsSettings> dynamics;
  std::optional<QuasiStaticSettings> quasi_static;
  std::optional<PeridynamicsSettings> peridynamics;
  TimeSettings time;
  OutputSettings output;
  std::vector<ProbeSettings> probes;
  std::vector<Stage> stages;             // that follow the scene as it stands
  std::shared_ptr<const Places> places;  // where each key stood in the file; null when in none

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("title").text("what the scene shows"), self.title);
    visit(Key("grid").required().text("background grid"), self.grid);
    visit(Key("initial_state")
              .file()
              .text("checkpoint of another run with [dynamics]: bodies of the same name go on from "
                    "there, with the loads and materials of this scene"),
          self.initial_state);
    visit(Key("bodies").required().length(1, 1000000).text("bodies"), self.bodies);
    visit(Key("heat").text("heat conduction; absent: not modelled"), self.heat);
    visit(Key("dynamics").text("explicit dynamics; absent: not modelled"), self.dynamics);
    visit(Key("quasi_static").text("equilibrium under load steps; absent: not modelled"),
          self.quasi_static);
    visit(
        Key("peridynamics").text("bodies as peridynamic points, with heat and flow; absent: none"),
        self.peridynamics);
    visit(Key("time").required().text("end and steps"), self.time);
    visit(Key("output").text("frames and checkpoints"), self.output);
    visit(Key("probes").text("fields recorded in time at single positions"), self.probes);
    visit(Key("stages").text(
              "what follows in the same run after time.end: other loads, properties, bodies"),
          self.stages);
  }
};

}  // namespace lapilli
