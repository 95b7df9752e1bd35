#include "lapilli/scene/validate.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lapilli/core/allowed.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/build_peridynamics.hpp"
#include "lapilli/scene/member_types.hpp"
#include "lapilli/scene/mistakes.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/validate_body.hpp"
#include "lapilli/scene/validate_heat.hpp"
#include "lapilli/scene/validate_names.hpp"
#include "lapilli/scene/validate_peridynamics.hpp"
#include "lapilli/scene/validate_stages.hpp"

namespace lapilli {
namespace {

// Every number again: scenes made in a program have passed no reader.
class RangeCheck {
 public:
  RangeCheck(const Scene& scene, Mistakes& mistakes) : scene_(scene), mistakes_(mistakes) {}

  template <class T>
  void check(const T& member, const Key& key, const std::string& path) const {
    if constexpr (std::is_same_v<T, double> ||
                  (std::is_integral_v<T> && !std::is_same_v<T, bool>)) {
      check_number(static_cast<double>(member), key, path);
    } else if constexpr (std::is_same_v<T, Value>) {
      check_value(member, key, path);
    } else if constexpr (is_optional<T>) {
      if (member) {
        check(*member, key, path);
      }
    } else if constexpr (is_vector<T>) {
      check_list(member, key, path);
    } else if constexpr (Indirect<T>) {
      mistakes_.gather(
          [&] { require_at(!member.empty() || !key.is_required, scene_, path, "is missing"); });
      if (!member.empty()) {
        check(*member, key, path);
      }
    } else if constexpr (std::is_same_v<T, Shape>) {
      mistakes_.gather(
          [&] { at_place(scene_, path, [&] { lapilli::check(member, dimension_of(scene_)); }); });
    } else if constexpr (Kinded<T>) {
      std::visit([&](const auto& alternative) { check(alternative, key, path); },
                 variant_of(member));
    } else if constexpr (Described<T>) {
      MemberCheck each{*this, path};
      T::describe(member, each);
    }
  }

 private:
  struct MemberCheck {
    const RangeCheck& ranges;
    const std::string& path;
    template <class T>
    void operator()(const Key& key, const T& member) {
      ranges.check(member, key, joined_path(path, key.name));
    }
  };

  void check_number(double number, const Key& key, const std::string& path) const {
    const std::string mistake = range_mistake(key, number);
    if (!mistake.empty()) {
      mistakes_.add(place_text(scene_.places.get(), path) + path + " " + mistake);
    }
  }

  void check_value(const Value& value, const Key& key, const std::string& path) const {
    if (const auto* in_time = std::get_if<Table>(&value.form())) {
      mistakes_.gather([&] { check_table(*in_time, path); });
      for (const double number : in_time->values) {
        check_number(number, key, path);
      }
    } else if (value.is_constant()) {
      check_number(value.at(0.0), key, path);
    }
  }

  void check_table(const Table& table, const std::string& path) const {
    require_at(!table.times.empty() && table.times.size() == table.values.size(), scene_, path,
               "needs as many values as times, at least one");
    require_at(std::all_of(table.times.begin(), table.times.end(),
                           [](double time) { return std::isfinite(time); }),
               scene_, path, "has a time that is not finite");
    require_at(table.is_ordered(), scene_, path,
               "has times that do not increase; two equal times, not three, are a jump");
  }

  template <class T>
  void check_list(const std::vector<T>& list, const Key& key, const std::string& path) const {
    const auto count = static_cast<Index>(list.size());
    mistakes_.gather([&] {
      require_at(count >= key.shortest && count <= key.longest, scene_, path, "must hold ",
                 allowed_length(key), ", got ", count);
    });
    for (std::size_t k = 0; k < list.size(); ++k) {
      check(list[k], key, element_path(path, k));
    }
  }

  const Scene& scene_;
  Mistakes& mistakes_;
};

void check_grid(const Scene& scene) {
  const std::size_t dimension = scene.grid.lower.size();
  require_at(scene.grid.upper.size() == dimension, scene, "grid.upper",
             "must have as many numbers as grid.lower, ", dimension, ", got ",
             scene.grid.upper.size());
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    require_at(scene.grid.upper[axis] > scene.grid.lower[axis], scene, "grid.upper",
               "must be above grid.lower, got ", scene.grid.lower[axis], " and ",
               scene.grid.upper[axis], " along axis ", axis);
  }
}

void check_quasi_static(const Scene& scene) {
  require_at(dimension_of(scene) > 1, scene, "quasi_static",
             "needs two or three dimensions, got 1");
  require_at(!scene.heat && !scene.peridynamics, scene, "quasi_static",
             "cannot share a scene with [heat] or [peridynamics]",
             ": their coupling is not modelled");
  require_at(scene.grid.shape_function != ShapeFunction::bspline, scene, "grid.shape_function",
             "must be linear or gimp where [quasi_static] is modelled, got bspline");
  require_at(scene.time.step || scene.time.steps, scene, "quasi_static",
             "has no stable step to choose from: give time.steps, the number of load steps");
  require_at(!scene.dynamics, scene, "quasi_static",
             "contradicts [dynamics]: both move the points");
}

void check_time(const Scene& scene) {
  require_at(!scene.time.step || !scene.time.steps, scene, "time.steps",
             "contradicts time.step: give one of them");
  require_at(!scene.output.every || !scene.output.every_steps, scene, "output.every_steps",
             "contradicts output.every: give one of them");
  require_at(scene.output.path.empty() || scene.output.path.ends_with(".vtkhdf"), scene,
             "output.path", "must end in .vtkhdf, got ", scene.output.path);
}

// A probe where no body is. Bodies that are known by their points only are left to build().
void require_in_a_body(const Scene& scene, const ProbeSettings& probe, const std::string& path) {
  const Vec3 at = place(probe.position);
  double least = std::numeric_limits<double>::infinity();
  for (const Body& body : scene.bodies) {
    const std::optional<Shape> shape = placed_shape(body);
    if (!shape) {
      return;
    }
    least = std::min(least, distance(*shape, at));
  }
  require_at(least <= 1e-9 * scene.grid.cell, scene, path + ".position", "lies ", least,
             " m outside of every body");
}

void check_probes(const Scene& scene) {
  std::set<std::string> names = {"time"};
  for (std::size_t k = 0; k < scene.probes.size(); ++k) {
    const ProbeSettings& probe = scene.probes[k];
    const std::string path = element_path("probes", k);
    check_dimension(scene, probe.position, path + ".position");
    require_at(!probe.name.empty() && probe.name.find_first_of("/,\"\n") == std::string::npos,
               scene, path + ".name", "must hold a word without slash, comma or quote, got '",
               probe.name, "'");
    require_at(names.insert(probe.name).second, scene, path + ".name", "is '", probe.name,
               "' as that of another column of the history");
    require_at(!probe.every || !probe.every_steps, scene, path + ".every_steps",
               "contradicts every: give one of them");
    require_in_a_body(scene, probe, path);
  }
}

}  // namespace

void validate(const Scene& as_written) {
  const Scene scene = with_resolved_files(as_written);
  Mistakes mistakes;
  RangeCheck(scene, mistakes).check(scene, Key(""), "");
  mistakes.throw_if_any();  // nothing below makes sense of numbers that are none
  check_grid(scene);
  mistakes.gather([&] { check_time(scene); });
  if (scene.quasi_static) {
    mistakes.gather([&] { check_quasi_static(scene); });
  }
  mistakes.gather([&] { validate_peridynamics(scene); });
  mistakes.gather([&] { validate_heat(scene); });
  mistakes.gather([&] { check_probes(scene); });
  validate_names(scene, mistakes);
  mistakes.gather([&] {
    require_at(scene.initial_state.empty() || scene.dynamics, scene, "initial_state",
               "has no effect without [dynamics]");
  });
  if (scene.dynamics) {
    mistakes.gather([&] {
      require_at(dimension_of(scene) > 1, scene, "dynamics",
                 "needs two (plane strain) or three dimensions, the grid has one");
      at_place(scene, "dynamics", [&] { check(*scene.dynamics, dimension_of(scene)); });
    });
  }
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const std::string path = element_path("bodies", k);
    validate_body(scene, scene.bodies[k], path, mistakes);
  }
  mistakes.throw_if_any();
  validate_stages(scene);
}

}  // namespace lapilli
