#include <cmath>

#include "bindings.hpp"
#include "convert_scene.hpp"

namespace lapilli::python {
namespace {

GivenPoints points_from(const std::string& owner, const Numbers& positions,
                        const Numbers& volumes) {
  require(positions.ndim() == 2 && positions.shape(1) >= 1 && positions.shape(1) <= 3, owner,
          ": positions must be an array (points, dimension)");
  require(volumes.ndim() == 1 && volumes.shape(0) == positions.shape(0), owner,
          ": volumes must hold one number a point");
  GivenPoints points;
  points.positions.assign(positions.data(), positions.data() + positions.size());
  points.volumes.assign(volumes.data(), volumes.data() + volumes.size());
  return points;
}

Numbers positions_of(const GivenPoints& points) {
  const auto rows = static_cast<py::ssize_t>(points.volumes.size());
  const auto columns = rows > 0 ? static_cast<py::ssize_t>(points.positions.size()) / rows : 0;
  return Numbers({rows, columns}, points.positions.data());
}

Numbers volumes_of(const GivenPoints& points) {
  return Numbers(static_cast<py::ssize_t>(points.volumes.size()), points.volumes.data());
}

}  // namespace

void Convert<GivenPoints>::load(const Where& where, py::handle given, GivenPoints& member) {
  if (py::isinstance<GivenPoints>(given)) {
    member = given.cast<GivenPoints>();
    return;
  }
  if (!PyTuple_Check(given.ptr()) || py::len(given) != 2) {
    where.refuse("a pair of arrays (positions, volumes)", given);
  }
  member = points_from(where.path(), numbers_from(where.path() + ": positions", given[py::int_(0)]),
                       numbers_from(where.path() + ": volumes", given[py::int_(1)]));
}

py::object Convert<GivenPoints>::show(const Key&, const GivenPoints& member) {
  return py::cast(member);
}

void bind_points(py::module_& module) {
  const std::string self = "(self: lapilli._core.Points";
  const std::string array = " -> numpy.typing.NDArray[numpy.float64]";
  py::class_<GivenPoints>(module, "Points",
                          "Points handed over as arrays; no scene file holds them.")
      .def(py::init([](const py::object& positions, const py::object& volumes,
                       const py::kwargs& unknown) {
             for (const auto& [name, value] : unknown) {
               throw py::type_error("Points: " + unknown_name("key", std::string(py::str(name)),
                                                              {"positions", "volumes"}));
             }
             if (positions.is_none() || volumes.is_none()) {
               throw py::type_error("Points: needs two arrays of numbers, positions and volumes");
             }
             return points_from(
                 "Points",
                 numbers_from("Points: needs two arrays of numbers: positions", positions),
                 numbers_from("Points: needs two arrays of numbers: volumes", volumes));
           }),
           py::arg("positions") = py::none(), py::arg("volumes") = py::none(),
           ("__init__" + self +
            ", positions: numpy.typing.ArrayLike, volumes: numpy.typing.ArrayLike) -> None")
               .c_str())
      .def_property_readonly(
          "positions", py::cpp_function(&positions_of, ("positions" + self + ")" + array).c_str()),
          "copy of the positions (points, dimension), m")
      .def_property_readonly(
          "volumes", py::cpp_function(&volumes_of, ("volumes" + self + ")" + array).c_str()),
          "copy of the volumes (points,), m^dimension")
      .def(
          "__len__", [](const GivenPoints& points) { return points.volumes.size(); },
          ("__len__" + self + ") -> int").c_str())
      .def(
          "__eq__",
          [](const GivenPoints& points, const py::object& other) {
            if (!py::isinstance<GivenPoints>(other)) {
              return false;
            }
            const auto& same = other.cast<const GivenPoints&>();
            return points.positions == same.positions && points.volumes == same.volumes;
          },
          ("__eq__" + self + ", other: object) -> bool").c_str())
      .def(
          "__repr__",
          [](const GivenPoints& points) { return message("<", points.volumes.size(), " points>"); },
          ("__repr__" + self + ") -> str").c_str())
      .def(py::pickle(
          [](const GivenPoints& points) {
            return py::make_tuple(positions_of(points), volumes_of(points));
          },
          [](const py::tuple& state) {
            return points_from("Points", state[0].cast<Numbers>(), state[1].cast<Numbers>());
          }));
}

}  // namespace lapilli::python
