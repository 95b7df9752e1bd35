#include <span>

#include "bindings.hpp"
#include "convert_scene.hpp"
#include "lapilli/core/interruption.hpp"
#include "lapilli/scene/tree_reader.hpp"
#include "simulation.hpp"

namespace pybind11::detail {

template <>
class type_caster<lapilli::Places> : public lapilli::python::InitializedCaster<lapilli::Places> {};

}  // namespace pybind11::detail

namespace lapilli::python {
namespace {

constexpr const char* places_name = "_places";

template <class Work>
auto without_gil(const Work& work) {
  const py::gil_scoped_release release;
  const Interruption interruption(raise_signals);
  return work();
}

py::object shown(const Scene& scene) { return Convert<Scene>::show(Key(""), scene); }

void bind_places(py::module_& module) {
  py::class_<Places, std::shared_ptr<Places>>(module, "_Places", "Where keys stand in a file.")
      .def(py::pickle(
          [](const Places& places) {
            py::dict rows;
            for (const auto& [path, place] : places.at) {
              rows[py::str(path)] = py::make_tuple(place.line, place.column);
            }
            return py::make_tuple(places.source, rows);
          },
          [](const py::tuple& state) {
            auto places = std::make_shared<Places>();
            places->source = state[0].cast<std::string>();
            for (const auto& [path, row] : state[1].cast<py::dict>()) {
              const auto place = row.cast<py::tuple>();
              places->at[path.cast<std::string>()] = {place[0].cast<int>(), place[1].cast<int>()};
            }
            return places;
          }));
}

/// Stands for "no value given"; None is a value.
py::object unset() { return py::module_::import("builtins").attr("Ellipsis"); }

std::vector<py::object> steps_of(const std::string& path) {
  std::vector<py::object> steps;
  for (const std::string& name : path_names(path)) {
    const bool is_index = name.find_first_not_of("0123456789") == std::string::npos;
    steps.push_back(is_index && !name.empty() ? py::object(py::int_(std::stoll(name)))
                                              : py::object(py::str(name)));
  }
  return steps;
}

/// Puts a value where the steps lead and returns the changed whole: lists inside are new ones.
py::object with_part(const py::object& whole, std::span<const py::object> steps,
                     const py::object& value, const std::string& path) {
  if (steps.empty()) {
    return value;
  }
  const py::object& step = steps.front();
  const bool is_index = py::isinstance<py::int_>(step);
  if (py::isinstance<py::list>(whole) || py::isinstance<py::tuple>(whole)) {
    auto list = py::reinterpret_steal<py::list>(PySequence_List(whole.ptr()));  // a copy
    // One element may stand for a list of one.
    const auto index = is_index ? step.cast<std::size_t>() : std::size_t{0};
    if (index >= list.size() || (!is_index && list.size() != 1)) {
      throw py::value_error(message(path, ": there is no entry ", std::string(py::str(step)),
                                    ", there are ", list.size(), " counted from 0"));
    }
    list[index] = with_part(list[index], is_index ? steps.subspan(1) : steps, value, path);
    return list;
  }
  if (is_index) {
    if (step.cast<std::size_t>() != 0) {
      throw py::value_error(message(path, ": there is one entry only"));
    }
    return with_part(whole, steps.subspan(1), value, path);
  }
  if (whole.is_none()) {
    throw py::value_error(message(path, ": what holds '", std::string(py::str(step)),
                                  "' is absent; set the whole of it first"));
  }
  const py::object part = steps.size() == 1 ? py::object(py::none()) : whole.attr(step);
  const py::object copy = py::module_::import("copy").attr("copy")(whole);
  py::setattr(copy, step, with_part(part, steps.subspan(1), value, path));
  return copy;
}

py::object with_member(const py::object& scene, const std::string& path, const py::object& value) {
  if (!value.is(unset())) {
    const std::vector<py::object> steps = steps_of(path);
    return with_part(scene, steps, value, path);
  }
  Scene changed = scene_of(scene);
  apply_override(changed, path);
  return shown(changed);
}

const std::string of_scene = "(self: lapilli._core.Scene";

void bind_toml(py::class_<Record<Scene>>& bound) {
  bound
      .def(
          "to_toml",
          [](const py::object& scene, bool everything) {
            const Scene made = scene_of(scene);
            return without_gil(
                [&] { return to_toml(made, everything ? Members::all : Members::changed); });
          },
          py::arg("everything") = false,
          ("to_toml" + of_scene +
           ", everything: bool = False) -> str\n\nThe scene as TOML; with defaults filled in if "
           "`everything`.")
              .c_str())
      .def(
          "to_json",
          [](const py::object& scene) {
            const Scene made = scene_of(scene);
            return without_gil([&] { return to_json(made); });
          },
          ("to_json" + of_scene +
           ") -> str\n\nEvery setting with defaults filled in; functions and arrays are named "
           "only.")
              .c_str());
}

void bind_files(py::class_<Record<Scene>>& bound) {
  bound
      .def_static(
          "load",
          [](const py::object& path) {
            const std::string name = file_name(path);
            return shown(without_gil([&] { return load_scene(name); }));
          },
          py::arg("path"),
          "load(path: str | os.PathLike[str]) -> Scene\n\nThe scene of a TOML file.")
      .def_static(
          "parse",
          [](const std::string& text, const std::string& name) {
            return shown(without_gil([&] { return parse_scene(text, name); }));
          },
          py::arg("text"), py::arg("name") = "scene",
          "parse(text: str, name: str = 'scene') -> Scene\n\nThe scene of a TOML text; messages "
          "call it by `name`.")
      .def(
          "save",
          [](const py::object& scene, const py::object& path) {
            const Scene made = scene_of(scene);
            const std::string name = file_name(path);
            without_gil([&] { save_scene(made, name); });
          },
          py::arg("path"),
          ("save" + of_scene +
           ", path: str | os.PathLike[str]) -> None\n\nWrite the scene as TOML. Functions and "
           "arrays, which no file "
           "holds, are a ValueError; what cannot be written is an OutputError.")
              .c_str())
      .def("set", &with_member, py::arg("path"), py::arg("value") = unset(),
           ("set" + of_scene +
            ", path: str, value: typing.Any = ...) -> Scene\n\nA copy with one member changed by "
            "its path: scene.set('grid.cell', 0.05), or as on the command line, "
            "scene.set('grid.cell=0.05').")
               .c_str());
}

}  // namespace

Scene scene_of(const py::object& given) {
  if (!Convert<Scene>::accepts(given)) {
    Where{Key("scene"), ""}.refuse("a Scene", given);
  }
  Scene scene;
  Convert<Scene>::read("", given, scene);
  return scene;
}

void Extras<Scene>::load(const py::dict& attributes, Scene& scene) {
  if (attributes.contains(places_name)) {
    scene.places = attributes[places_name].cast<std::shared_ptr<Places>>();
  }
}

void Extras<Scene>::show(const Scene& scene, py::dict& attributes) {
  if (scene.places) {
    attributes[places_name] = std::const_pointer_cast<Places>(scene.places);
  }
}

void bind_scene(py::module_& module) {
  bind_places(module);
  bind_struct<Rotation>(module, "Rotation", "A body turned at constant speed.");
  bind_struct<Translation>(module, "Translation", "A body moved at constant velocity.");
  bind_struct<Swirl>(module, "Swirl", "Circles that turn at their own speeds.");
  bind_struct<GeostaticStress>(module, "Geostatic",
                               "The stress of a body that rests below an even free surface, level "
                               "or inclined.");
  bind_struct<Body>(module, "Body",
                    "A body: where its points come from (one of shape, points_file, points), "
                    "what it is made of, how it starts and how it is moved.");
  bind_struct<FluidWallBody>(
      module, "FluidWall",
      "A wall of a peridynamic fluid: its shape, and what it does to flow and heat.");
  bind_struct<PeridynamicHeatSettings>(module, "PeridynamicHeat",
                                       "Heat conduction on the thermal horizon.");
  bind_struct<PeridynamicFlowSettings>(module, "PeridynamicFlow",
                                       "Weakly compressible viscous flow on the fluid horizon.");
  bind_struct<PeridynamicsSettings>(
      module, "Peridynamics",
      "Bodies as points that act on each other at a distance instead of through a grid.");
  bind_struct<GridSettings>(module, "Grid",
                            "The background grid; its corners give the dimension of the scene.");
  bind_struct<TimeSettings>(module, "Time", "When the run ends and how its steps are chosen.");
  bind_struct<ProbeSettings>(module, "Probe",
                             "A field recorded in time at one position, or at one material point.");
  bind_struct<OutputSettings>(module, "Output", "What a run leaves on disk.");
  bind_struct<Stage>(module, "Stage",
                     "What follows in the same run: what changes in the scene, and when it ends.");
  auto scene =
      bind_struct<Scene>(module, "Scene",
                         "All that a run computes, as plain data. A section that is absent "
                         "is physics that is not modelled.");
  bind_files(scene);
  bind_toml(scene);
}

}  // namespace lapilli::python
