#include "bindings.hpp"
#include "convert_geometry.hpp"

namespace lapilli::python {

namespace {

constexpr int deepest_nest = 200;  // of shapes; as deep as any file may go

/// Counts how deep shapes lie in each other, so that one that contains itself comes to an end.
class Nesting {
 public:
  explicit Nesting(const Where& where) {
    require(depth_ < deepest_nest, where.owner, ": shapes are nested more than ", deepest_nest,
            " deep; does one contain itself?");
    ++depth_;
  }
  ~Nesting() { --depth_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;

 private:
  static thread_local int depth_;
};
thread_local int Nesting::depth_ = 0;

}  // namespace

void Convert<Shape>::load(const Where& where, py::handle given, Shape& member) {
  const Nesting nesting(where);
  if (!load_alternative(where, given, static_cast<Shape::variant&>(member))) {
    where.refuse("a shape such as Box or Disk", given);
  }
}

py::object Convert<Shape>::show(const Key& key, const Shape& member) {
  return Convert<Shape::variant>::show(key, member);
}

void Convert<Nested>::load(const Where& where, py::handle given, Nested& member) {
  Shape shape;
  Convert<Shape>::load(where, given, shape);
  member = Nested(std::move(shape));
}

py::object Convert<Nested>::show(const Key& key, const Nested& member) {
  return member.empty() ? py::object(py::none()) : Convert<Shape>::show(key, *member);
}

namespace {

py::array_t<double> distances(const py::object& given, const Numbers& positions) {
  require(positions.ndim() == 2 && positions.shape(1) >= 1 && positions.shape(1) <= 3,
          "positions must be an array (n, dimension)");
  Shape shape;
  Convert<Shape>::load(Where{Key("shape"), ""}, given, shape);
  check(shape, static_cast<int>(positions.shape(1)));
  py::array_t<double> all(positions.shape(0));
  for (py::ssize_t row = 0; row < positions.shape(0); ++row) {
    Vec3 at = Vec3::Zero();
    std::copy_n(positions.data(row, 0), positions.shape(1), at.data());
    all.mutable_at(row) = distance(shape, at);
  }
  return all;
}

/// `one - other` and its like: the class called `kind` of both.
template <class Combine>
auto combined(Combine combine) {
  return [combine](const py::object& one, const py::object& other) -> py::object {
    if (!py::isinstance<AnyShape>(other)) {
      return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    }
    return combine(py::module_::import("lapilli._core"), one, other);
  };
}

py::object list_of(const py::object& one, const py::object& other) {
  py::list both;
  both.append(one);
  both.append(other);
  return both;
}

void bind_shape(py::module_& module) {
  const std::string self = "(self: lapilli._core.Shape";
  py::class_<AnyShape>(
      module, "Shape",
      "Any shape. Scenes of one or two dimensions leave out the last coordinates."
      "\n\n``one | other`` is their union, ``one & other`` what lies in both, ``one "
      "- other`` what lies in one and not in the other.")
      .def("distance", &distances, py::arg("positions"),
           "distance(self: lapilli._core.Shape, positions: numpy.typing.ArrayLike) -> "
           "numpy.typing.NDArray[numpy.float64]\n\nSigned distance of positions (n, dimension) to "
           "the surface, negative inside, m.")
      .def("__or__",
           combined([](const py::module_& core, const py::object& one, const py::object& other) {
             return core.attr("Union")(py::arg("shapes") = list_of(one, other));
           }),
           ("__or__" + self + ", other: Shape) -> Union\n\nWhat lies in any of both.").c_str())
      .def("__and__",
           combined([](const py::module_& core, const py::object& one, const py::object& other) {
             return core.attr("Intersection")(py::arg("shapes") = list_of(one, other));
           }),
           ("__and__" + self + ", other: Shape) -> Intersection\n\nWhat lies in both.").c_str())
      .def("__sub__",
           combined([](const py::module_& core, const py::object& one, const py::object& other) {
             return core.attr("Difference")(py::arg("shape") = one, py::arg("minus") = other);
           }),
           ("__sub__" + self + ", other: Shape) -> Difference\n\nWhat lies outside of the other.")
               .c_str())
      .def(
          "rotated",
          [](const py::object& of, double degrees, const py::kwargs& more) {
            return py::module_::import("lapilli._core")
                .attr("Rotated")(py::arg("shape") = of, py::arg("degrees") = degrees, **more);
          },
          py::arg("degrees"),
          ("rotated" + self +
           ", degrees: float, **more: typing.Any) -> Rotated\n\nTurned; ``center`` and ``axis`` as "
           "for `Rotated`.")
              .c_str())
      .def(
          "translated",
          [](const py::object& of, const py::object& by) {
            return py::module_::import("lapilli._core")
                .attr("Translated")(py::arg("shape") = of, py::arg("by") = by);
          },
          py::arg("by"),
          ("translated" + self +
           ", by: collections.abc.Sequence[float]) -> Translated\n\nMoved, m.")
              .c_str());
}

}  // namespace

void bind_geometry(py::module_& module) {
  bind_shape(module);
  bind_struct<Box>(
      module, "Box",
      "Interval, rectangle or box with sides along the axes; infinite along axes beyond "
      "the given numbers.");
  bind_struct<HalfSpace>(module, "HalfSpace",
                         "Everything on the side of a plane that its normal points away from.");
  bind_struct<Disk>(module, "Disk", "Disk in the x-y plane; infinite along z.");
  bind_struct<Annulus>(module, "Annulus",
                       "Ring between two circles in the x-y plane; infinite along z.");
  bind_struct<Ellipse>(module, "Ellipse",
                       "Ellipse in the x-y plane with its axes along x and y; infinite along z.");
  bind_struct<Ellipsoid>(module, "Ellipsoid", "Ellipsoid with its axes along x, y and z.");
  bind_struct<HeightField>(module, "HeightField",
                           "Ground below heights on a regular grid, down to a flat bottom.");
  bind_struct<Sphere>(module, "Sphere", "Ball.");
  bind_struct<Cylinder>(module, "Cylinder", "Cylinder with flat ends, from start to end.");
  bind_struct<Polygon>(module, "Polygon",
                       "Polygon in the x-y plane, convex or not; infinite along z.");
  bind_struct<Mesh>(module, "Mesh", "What lies inside a closed surface of triangles.");
  bind_struct<ImageMask>(
      module, "Image",
      "The bright (or dark) pixels of an image, in the x-y plane; infinite along "
      "z.");
  bind_struct<Union>(module, "Union", "What lies in any of the shapes.");
  bind_struct<Intersection>(module, "Intersection", "What lies in all of the shapes.");
  bind_struct<Difference>(module, "Difference", "What lies in one shape and not in another.");
  bind_struct<Rotated>(module, "Rotated",
                       "A shape turned about an axis by the right-hand rule; in two dimensions "
                       "counter-clockwise.");
  bind_struct<Translated>(module, "Translated", "A shape moved without turning.");
}

}  // namespace lapilli::python
