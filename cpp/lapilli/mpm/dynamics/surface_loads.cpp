#include "lapilli/mpm/dynamics/surface_loads.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/span_of_shape.hpp"
#include "lapilli/mpm/dynamics/cell_sums.hpp"
#include "lapilli/mpm/surface/surface_regions.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {
namespace {

/// sum V S and sum V grad S of the points of one strip, of one velocity field.
template <int Dim, class Shape>
void project_rows(const DynamicsData<Dim>& data, const NodeField<Dim>& field,
                  double* const (&to)[1 + Dim], Index begin, Index end) {
  const Stencil<Dim, Shape> stencil(field.grid);
  CellSums<Dim, Shape, 1 + Dim> sums(stencil, to);
  const ShapeOfBody<Shape> shape_of(data.half_widths);
  const double* position = data.points.position().data();
  for (Index row = begin; row < end; ++row) {
    const AxisWeights<Dim, Shape> axes(field.grid, shape_of(data.points.body()[row]),
                                       position + row * Dim, field.offset);
    const SimdWeights<Dim, Shape> w(axes.value, axes.slope);
    const double volume = data.points.volume()[row];
    sums.move_to(axes.first);
    for (int q = 0; q < Stencil<Dim, Shape>::quads; ++q) {
      sums.sum[0][q] += w.value[q] * volume;
      for (int axis = 0; axis < Dim; ++axis) {
        sums.sum[1 + axis][q] += w.slope[axis][q] * volume;
      }
    }
  }
}

}  // namespace

template <int Dim>
SurfaceLoads<Dim>::SurfaceLoads(const DynamicsData<Dim>& data, const DynamicsProblem<Dim>& problem)
    : laws_(problem.settings.boundaries),
      nodes_(laws_.size()),
      work_(laws_.size(), 0.0),
      impulse_(laws_.size(), Vec3::Zero()),
      contact_(data.grid, contact_faces(data.walls)),
      outside_(data.grid, static_cast<int>(problem.bodies.size())),
      version_(data.points.version()) {
  check_regions(laws_, Dim);
  outside_.start(data.points, problem.distance);
  if (problem.start != nullptr) {
    go_on(*problem.start);
  }
  compare_with_shapes(data, problem);
  find_surface(data);
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    start_area_.push_back(area_of(law));
  }
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    if (nodes_[law].node.empty()) {
      const Shape* region = region_of(laws_[law]);
      require(false, "dynamics.boundaries.", law, " (", name_of_law(laws_[law], law),
              ") selects no surface: ",
              region != nullptr ? message("its region", span_of_shape(*region),
                                          " covers none that an earlier condition left")
                                : std::string("earlier conditions took all of it"));
    }
  }
}

template <int Dim>
void SurfaceLoads<Dim>::project_surface(const DynamicsData<Dim>& data) {
  const bool single = data.fields.is_single();
  const auto whole = static_cast<std::size_t>(data.grid.node_count() + 4);
  const std::size_t size = single ? whole : static_cast<std::size_t>(data.fields.node_count() + 4);
  double* to[1 + Dim];
  for (int which = 0; which <= Dim; ++which) {
    scratch_[which].assign(size, 0.0);
    to[which] = scratch_[which].data();
  }
  with_transfer(data.shape, VelocityTransfer::flip, [&]<class Shape, VelocityTransfer>() {
    const auto project = [&](const NodeField<Dim>& field, Index begin, Index end) {
      project_rows<Dim, Shape>(data, field, to, begin, end);
    };
    data.order.for_each_strip([&](Index begin, Index end) {
      data.fields.for_each_run(data.points.body().data(), begin, end, project);
    });
  });
  sums_.fraction.resize(whole);
  sums_.area_vector.resize(whole);
  const double per_cell = 1.0 / data.grid.cell_volume();
  parallel_for(data.grid.node_count(), [&](Index node) {
    double volume = 0.0;
    Vec<Dim> area = Vec<Dim>::Zero();
    for (int field = 0; field < data.fields.count(); ++field) {
      const Index here = single ? node : data.fields.node_in(field, node);
      if (here >= 0) {
        volume += scratch_[0][here];
        for (int axis = 0; axis < Dim; ++axis) {
          area[axis] += scratch_[1 + axis][here];
        }
      }
    }
    sums_.fraction[node] = volume * per_cell;
    sums_.area_vector[node] = area;
  });
}

/// Call action(node of the arrays, shares by axis) for the velocity fields that a load acts on.
template <int Dim>
template <class Action>
void SurfaceLoads<Dim>::for_each_share(const DynamicsData<Dim>& data, const Nodes& nodes,
                                       std::size_t k, const Action& action) const {
  if (data.fields.is_single()) {
    action(nodes.node[k], Vec<Dim>(Vec<Dim>::Ones()));
    return;
  }
  for (int field = 0; field < data.fields.count(); ++field) {
    const Vec<Dim>& shares =
        nodes.shares[k * static_cast<std::size_t>(data.fields.count()) + field];
    if (!shares.isZero(0.0)) {
      action(data.fields.node_in(field, nodes.node[k]), shares);
    }
  }
}

template <int Dim>
void SurfaceLoads<Dim>::find_surface(const DynamicsData<Dim>& data) {
  project_surface(data);
  if (data.points.version() != version_) {
    outside_.follow(data.points);
    version_ = data.points.version();
  }
  NodalAreas<Dim> areas = free_areas(data.grid, sums_, outside_);
  ratios_.scale(areas, outside_);
  const auto parts = divide_surface<Dim>(
      data.grid, areas,
      [&] {
        return surface_places<Dim>(data.grid, data.points, data.shape, data.half_widths, areas,
                                   contact_faces(data.walls));
      },
      regions_of(laws_));
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    Nodes& nodes = nodes_[law];
    nodes = {};
    for (const SurfacePart<Dim>& part : parts[law]) {
      nodes.node.push_back(areas.node[part.row]);
      nodes.area_vector.push_back(part.vector);
      nodes.area.push_back(part.share * areas.area[part.row]);
      nodes.normal.push_back(areas.normal[part.row]);
      nodes.position.push_back(areas.position[part.row]);
    }
    ratios_.scale(law, nodes.area);
    nodes.value.resize(nodes.node.size());
    nodes.force.resize(nodes.node.size());
  }
}

template <int Dim>
void SurfaceLoads<Dim>::add_forces(DynamicsData<Dim>& data, double time, double step) {
  find_surface(data);
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    Nodes& n = nodes_[law];
    const auto* traction = std::get_if<Traction>(&laws_[law]);
    if (!data.fields.is_single()) {
      n.shares = traction != nullptr ? shares_of_traction(data, areas_of_fields(), n.node, n.normal)
                                     : shares_of_pressure(data, areas_of_fields(), n.node);
    }
    const Value& value =
        traction != nullptr ? traction->factor : std::get<Pressure>(laws_[law]).value;
    value.evaluate_mean(n.position, {}, time, time + step, n.value);
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      if (traction != nullptr) {
        n.force[k] = n.area[k] * n.value[k] * Eigen::Map<const Vec<Dim>>(traction->value.data());
      } else {
        n.force[k] = -n.value[k] * n.area_vector[k];
      }
      for_each_share(data, n, k, [&](Index node, const Vec<Dim>& share) {
        for (int axis = 0; axis < Dim; ++axis) {
          data.nodes.increment(axis)[node] += share[axis] * n.force[k][axis];
        }
      });
    }
  }
}

template <int Dim>
void SurfaceLoads<Dim>::book(const DynamicsData<Dim>& data, double step) {
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    const Nodes& n = nodes_[law];
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      for_each_share(data, n, k, [&](Index node, const Vec<Dim>& share) {
        for (int axis = 0; axis < Dim; ++axis) {
          const double middle =
              data.nodes.velocity(axis)[node] - 0.5 * data.nodes.increment(axis)[node];
          work_[law] += step * share[axis] * n.force[k][axis] * middle;
          impulse_[law][axis] += step * share[axis] * n.force[k][axis];
        }
      });
    }
  }
}

template <int Dim>
void SurfaceLoads<Dim>::save(Archive& archive, const std::string& name) const {
  archive.write(name + "/work", work_);
  std::vector<double> impulse;
  for (const Vec3& of_law : impulse_) {
    impulse.insert(impulse.end(), of_law.data(), of_law.data() + 3);
  }
  archive.write(name + "/impulse", impulse);
  ratios_.save(archive, name + "/area_ratios");
  outside_.save(archive, name + "/outside");
}

template <int Dim>
void SurfaceLoads<Dim>::load(const Archive& archive, const std::string& name) {
  archive.read(name + "/work", std::span<double>(work_));
  std::vector<double> impulse(3 * impulse_.size());
  archive.read(name + "/impulse", std::span<double>(impulse));
  for (std::size_t law = 0; law < impulse_.size(); ++law) {
    impulse_[law] = Eigen::Map<const Vec3>(impulse.data() + 3 * law);
  }
  ratios_.load(archive, name + "/area_ratios");
  outside_.load(archive, name + "/outside");
}

template class SurfaceLoads<2>;
template class SurfaceLoads<3>;

}  // namespace lapilli
