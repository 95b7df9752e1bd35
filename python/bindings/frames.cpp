#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstring>
#include <mutex>

#include "bindings.hpp"
#include "convert.hpp"
#include "initialized.hpp"
#include "lapilli/core/interruption.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/merge.hpp"
#include "lapilli/output/verify.hpp"
#include "simulation.hpp"

namespace lapilli::python {

/// A reader that several threads of Python may share.
class SharedReader {
 public:
  explicit SharedReader(const std::string& path) : reader_(path) {}

  const FrameIndex& index() const { return reader_.index(); }
  Words read(std::size_t column, Index frame) {
    const std::lock_guard lock(mutex_);
    return reader_.read(column, frame);
  }
  std::size_t column_of(const std::string& name) const { return reader_.column_of(name); }

 private:
  std::mutex mutex_;
  FrameReader reader_;
};

}  // namespace lapilli::python

namespace pybind11::detail {

template <>
class type_caster<lapilli::python::SharedReader>
    : public lapilli::python::InitializedCaster<lapilli::python::SharedReader> {};

}  // namespace pybind11::detail

namespace lapilli::python {

namespace {

py::array read_field(SharedReader& reader, Index frame, const std::string& name) {
  if (frame < 0 || frame >= reader.index().frames()) {
    throw py::index_error(message("there is no frame ", frame));
  }
  const std::size_t column = reader.column_of(name);
  const Column& layout = reader.index().columns[column];
  const Words words = [&] {
    const py::gil_scoped_release release;
    return reader.read(column, frame);
  }();
  std::vector<py::ssize_t> shape = {reader.index().points_of(frame)};
  if (layout.components > 1) {
    shape.push_back(layout.components);
  }
  py::array array = layout.is_index ? py::array(py::array_t<Index>(shape))
                                    : py::array(py::array_t<double>(shape));
  if (layout.is_single) {
    const auto* numbers = reinterpret_cast<const std::byte*>(words.data());
    auto* to = static_cast<double*>(array.mutable_data());
    for (py::ssize_t k = 0; k < array.size(); ++k) {
      float number = 0.0F;
      std::memcpy(&number, numbers + k * py::ssize_t{sizeof number}, sizeof number);
      to[k] = number;
    }
  } else {
    std::memcpy(array.mutable_data(), words.data(), static_cast<std::size_t>(array.nbytes()));
  }
  return array;
}

std::vector<std::string> field_names_of(const SharedReader& reader) {
  std::vector<std::string> names;
  for (const Column& column : reader.index().columns) {
    if (column.name != "Points") {
      names.push_back(field_name(column));
    }
  }
  return names;
}

std::vector<Index> point_counts_of(const SharedReader& reader) {
  std::vector<Index> counts;
  for (Index frame = 0; frame < reader.index().frames(); ++frame) {
    counts.push_back(reader.index().points_of(frame));
  }
  return counts;
}

void bind_frame_files(py::module_& module) {
  module.def(
      "merge",
      [](const py::object& from, const py::object& to) {
        const std::string source = file_name(from), target = file_name(to);
        const py::gil_scoped_release release;
        const Interruption interruption(raise_signals);
        merge(source, target);
      },
      py::arg("from_path"), py::arg("to_path"),
      "merge(from_path: str | os.PathLike[str], to_path: str | os.PathLike[str]) -> "
      "None\n\nGather a series of frames into one self-contained file.");
  module.def(
      "verify",
      [](const std::string& frames) {
        const Verification found = [&] {
          const py::gil_scoped_release release;
          const Interruption interruption(raise_signals);
          return verify(frames);
        }();
        return py::make_tuple(found.frames, found.whole_frames, found.damages);
      },
      py::arg("frames"),
      "verify(frames: str) -> tuple[int, int, list[str]]\n\nFrames of a run or a merged file, "
      "those "
      "of which every number fits its checksum, and what is damaged, checkpoints too.");
  module.def(
      "rebuild_index",
      [](const std::string& frames) {
        const py::gil_scoped_release release;
        return rebuild_index(frames);
      },
      py::arg("frames"),
      "rebuild_index(frames: str) -> int\n\nMake a lost or damaged index anew from the data files "
      "beside it; the number of frames.");
}

}  // namespace

void bind_frames(py::module_& module) {
  const std::string self = "(self: lapilli._core.FrameReader";
  py::class_<SharedReader>(module, "FrameReader",
                           "Reads the frames of a run and gives no number that does not fit its "
                           "checksum.")
      .def(py::init([](const std::string& path) {
             const py::gil_scoped_release release;
             return std::make_unique<SharedReader>(path);
           }),
           py::arg("path"), ("__init__" + self + ", path: str) -> None").c_str())
      .def("read", &read_field, py::arg("frame"), py::arg("name"),
           ("read" + self +
            ", frame: int, name: str) -> numpy.typing.NDArray[typing.Any]\n\nOne field of one "
            "frame, one row per point in the order of ids.")
               .c_str())
      .def_property_readonly(
          "times",
          py::cpp_function([](const SharedReader& reader) { return reader.index().times; },
                           ("times" + self + ") -> list[float]").c_str()),
          "of every frame, s")
      .def_property_readonly(
          "point_counts",
          py::cpp_function(&point_counts_of, ("point_counts" + self + ") -> list[int]").c_str()),
          "points in every frame")
      .def_property_readonly(
          "fields", py::cpp_function(&field_names_of, ("fields" + self + ") -> list[str]").c_str()),
          "names that can be read beside position");
  bind_frame_files(module);
}

}  // namespace lapilli::python
