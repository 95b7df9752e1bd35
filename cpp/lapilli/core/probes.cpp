#include "lapilli/core/probes.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/allowed.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

Vec3 position_of(const Points& points, Index row) {
  Vec3 at = Vec3::Zero();
  const auto width = static_cast<Index>(points.dimension());
  std::copy_n(points.position().begin() + row * width, width, at.data());
  return at;
}

/// A row with what it is chosen by; ids decide between equal distances, as rows may be re-ordered.
struct Near {
  double square;  // m^2
  Index id;
  Index row;
  bool operator<(const Near& other) const {
    return square != other.square ? square < other.square : id < other.id;
  }
};

/// The nearest `count` points of one body, or of the first `bodies` bodies where `body` is -1.
std::vector<Near> nearest_points(const Points& points, const Vec3& to, std::size_t count,
                                 Index body, int bodies) {
  std::vector<Near> near;
  for (Index row = 0; row < points.size(); ++row) {
    const Index own = points.body()[static_cast<std::size_t>(row)];
    if (body < 0 ? own >= bodies : own != body) {
      continue;
    }
    near.push_back({(position_of(points, row) - to).squaredNorm(),
                    points.id()[static_cast<std::size_t>(row)], row});
    std::push_heap(near.begin(), near.end());
    if (near.size() > count) {
      std::pop_heap(near.begin(), near.end());
      near.pop_back();
    }
  }
  std::sort_heap(near.begin(), near.end());
  return near;
}

/// Whether a point so near says that material is there: half the diagonal of its box, and a fifth.
bool is_material_at(const Points& points, const Near& nearest) {
  const int dimension = points.dimension();
  const double spacing =
      std::pow(points.volume()[static_cast<std::size_t>(nearest.row)], 1.0 / dimension);
  return nearest.square <= std::pow(1.2 * spacing, 2) * std::max(1.0, 0.25 * dimension);
}

/// How much each of the near points counts in a linear fit at `to`.
Eigen::VectorXd fit_weights(const Points& points, const Vec3& to, const std::vector<Near>& near) {
  const auto rows = static_cast<Eigen::Index>(near.size());
  const double reach = 1.2 * std::sqrt(near.back().square);
  if (reach == 0.0) {
    return Eigen::VectorXd::Constant(rows, 1.0 / static_cast<double>(rows));
  }
  Eigen::MatrixXd basis(rows, points.dimension() + 1);
  Eigen::VectorXd root(rows);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const Near& one = near[static_cast<std::size_t>(k)];
    root[k] = 1.0 - one.square / (reach * reach);
    basis(k, 0) = root[k];
    for (int axis = 0; axis < points.dimension(); ++axis) {
      basis(k, axis + 1) = root[k] * (position_of(points, one.row)[axis] - to[axis]) / reach;
    }
  }
  // The first row of the pseudo-inverse; of least norm where the points span less than the space.
  const Eigen::MatrixXd inverse = basis.completeOrthogonalDecomposition().pseudoInverse();
  return inverse.row(0).transpose().cwiseProduct(root);
}

/// A value as a weighted sum over points; none where no material is.
struct Fit {
  std::vector<Near> near;
  Eigen::VectorXd weights;

  double value(const Field& field, int component) const {
    double sum = near.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    for (std::size_t k = 0; k < near.size(); ++k) {
      sum += weights[static_cast<Eigen::Index>(k)] *
             field.values[static_cast<std::size_t>(near[k].row * field.components + component)];
    }
    return sum;
  }
};

Fit only(const Points& points, Index id) {
  const auto found = std::find(points.id().begin(), points.id().end(), id);
  if (found == points.id().end()) {
    return {};  // it has left
  }
  return {{{0.0, id, found - points.id().begin()}}, Eigen::VectorXd::Ones(1)};
}

Fit fit_at(const Points& points, const Vec3& position, int bodies) {
  std::vector<Near> near = nearest_points(points, position, 1, -1, bodies);
  if (near.empty() || !is_material_at(points, near.front())) {
    return {};
  }
  const auto count = static_cast<std::size_t>(std::lround(std::pow(3.0, points.dimension())));
  const Index body = points.body()[static_cast<std::size_t>(near.front().row)];
  near = nearest_points(points, position, count, body, bodies);
  const Eigen::VectorXd weights = fit_weights(points, position, near);
  return {std::move(near), weights};
}

std::vector<std::string> component_names(const std::string& name, int components, int dimension) {
  if (components == 1) {
    return {name};
  }
  const char* symmetric[] = {"xx", "yy", "zz", "xy", "yz", "xz"};
  std::vector<std::string> names;
  for (int k = 0; k < components; ++k) {
    std::string end = std::to_string(k);
    if (components == dimension) {
      end = std::string(1, "xyz"[k]);
    } else if (components == 6) {
      end = symmetric[k];
    } else if (components == dimension * dimension) {
      end = {"xyz"[k / dimension], "xyz"[k % dimension]};
    }
    names.push_back(name + "_" + end);
  }
  return names;
}

Field field_called(Simulation& simulation, const std::vector<Field>& fields, const Probe& probe) {
  Points& points = simulation.points();
  if (probe.field == "position") {
    return {"position", "m", points.dimension(), points.position()};
  }
  std::vector<std::string> names = {"position"};
  for (const Field& field : fields) {
    if (field.name == probe.field) {
      return field;
    }
    names.push_back(field.name);
  }
  throw std::invalid_argument("probe '" + probe.name +
                              "': " + unknown_name("field", probe.field, names));
}

}  // namespace

Probes::Probes(const Simulation& simulation, std::vector<Probe> probes, int bodies)
    : probes_(std::move(probes)), bodies_(bodies) {
  for (const Probe& probe : probes_) {
    Index id = -1;
    if (probe.material_point) {
      id = nearest_points(simulation.points(), probe.position, 1, -1, bodies).at(0).id;
    }
    ids_.push_back(id);
  }
}

std::vector<Scalar> Probes::read(Simulation& simulation, bool at_start) const {
  std::vector<Scalar> all;
  if (probes_.empty()) {
    return all;
  }
  const std::vector<Field> fields = simulation.fields();
  const Points& points = simulation.points();
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    const Probe& probe = probes_[p];
    const Field field = field_called(simulation, fields, probe);
    const Fit fit = ids_[p] < 0 ? fit_at(points, probe.position, bodies_) : only(points, ids_[p]);
    require(!fit.near.empty() || !at_start, "probe '", probe.name, "' is outside of every body");
    const auto names = component_names(probe.name, field.components, points.dimension());
    for (int c = 0; c < field.components; ++c) {
      all.push_back(
          {names[static_cast<std::size_t>(c)], fit.value(field, c), field.unit,
           field.name + (probe.material_point ? " of a material point" : " at a position")});
    }
  }
  return all;
}

}  // namespace lapilli
