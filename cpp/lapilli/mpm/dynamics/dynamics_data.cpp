#include "lapilli/mpm/dynamics/dynamics_data.hpp"

#include <algorithm>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/point_kernel.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {

template <int Dim>
DynamicsNodes<Dim>::DynamicsNodes(const Grid<Dim>& grid, ShapeFunction shape,
                                  const DynamicsSettings& settings)
    : limits_strain_(shape == ShapeFunction::linear),
      fades_(settings.transfer == VelocityTransfer::blended_apic),
      damps_(settings.local_damping > 0.0),
      size_(grid.node_count() + 4),
      layer_(grid.node_stride(Dim - 1)) {
  const int always = 1 + (settings.stress_update == StressUpdate::musl ? 3 : 2) * Dim;
  limited_ = limits_strain_ ? always : 1;
  faded_ = always + (limits_strain_ ? Dim : 0);
  damped_ = faded_ + (fades_ ? Dim + 1 : 0);
  arrays_ = damped_ + (damps_ ? Dim : 0);
  values_.assign(static_cast<std::size_t>(size_ * arrays_), 0.0);
}

template <int Dim>
void DynamicsNodes<Dim>::clear(std::pair<int, int> layers) {
  clear_range(layers.first * layer_, layers.second * layer_);
}

template <int Dim>
void DynamicsNodes<Dim>::clear(Index count) {
  if (count + 4 > size_) {
    size_ = count + count / 4 + 4;  // windows grow and shrink
    values_.assign(static_cast<std::size_t>(size_ * arrays_), 0.0);
  }
  clear_range(0, count);
}

template <int Dim>
void DynamicsNodes<Dim>::clear_range(Index first, Index last) {
  const Index from = first_ < last_ ? std::min(first_, first) : first, to = std::max(last_, last);
  parallel_ranges(to - from, [&](Index begin, Index end) {
    for (int which = 0; which < 1 + 2 * Dim; ++which) {
      std::fill(array(which) + from + begin, array(which) + from + end, 0.0);
    }
    if (fades_) {
      std::fill(fade() + from + begin, fade() + from + end, 0.0);
    }
  });
  first_ = first;
  last_ = last;
}

template <int Dim>
void DynamicsNodes<Dim>::clear_second_velocity() {
  parallel_ranges(last_ - first_, [&](Index begin, Index end) {
    for (int axis = 0; axis < Dim; ++axis) {
      std::fill(second_velocity(axis) + first_ + begin, second_velocity(axis) + first_ + end, 0.0);
    }
  });
}

template <int Dim>
double full_cell(const DynamicsData<Dim>& data) {
  double density = std::numeric_limits<double>::infinity();
  for (const StressMaterial& material : data.materials) {
    density = std::min(density, material.density);
  }
  return density * data.grid.cell_volume();
}

namespace {

template <int Dim>
std::vector<std::vector<StateVariable>> variables_of(const DynamicsProblem<Dim>& problem) {
  std::vector<std::vector<StateVariable>> all;
  for (const DynamicsBody& body : problem.bodies) {
    all.push_back(state_variables(body.material));
  }
  if (problem.start) {
    for (const Solid& solid : problem.start->other_stages) {
      all.push_back(state_variables(solid));
    }
  }
  return all;
}

}  // namespace

template <int Dim>
DynamicsData<Dim>::DynamicsData(Points& of_points, const DynamicsProblem<Dim>& problem)
    : grid(problem.grid),
      shape(problem.shape),
      settings(problem.settings),
      walls(walls_of(problem.settings)),
      points(of_points),
      mass(of_points, 1),
      velocity(of_points, Dim),
      stress(of_points, stress_components),
      states(of_points, variables_of(problem)),
      order(problem.grid, problem.shape == ShapeFunction::linear ? 2 : 3),
      fields(problem.grid),
      nodes(problem.grid, problem.shape, problem.settings) {
  check(settings, Dim);
  std::copy(settings.gravity.begin(), settings.gravity.end(), gravity.data());
  gravity *= settings.gravity_factor.at(problem.start ? problem.start->time : 0.0);
  require(points.dimension() == Dim, "momentum of dimension ", Dim, " got points of dimension ",
          points.dimension());
  for (const DynamicsBody& body : problem.bodies) {
    require(body.half_width > 0.0 && body.half_width <= 0.5,
            "half width of a point must lie in (0, 0.5] cells, got ", body.half_width);
    half_widths.push_back(shape == ShapeFunction::bspline ? 0.5 : body.half_width);
    materials.emplace_back(body.material, body.label);
  }
  make_optional_arrays(problem);
  constexpr double empty_share = 1e-15;  // of a cell full of the lightest material
  empty_node = empty_share * full_cell(*this);
  start_points(problem);
}

template <int Dim>
void DynamicsData<Dim>::make_optional_arrays(const DynamicsProblem<Dim>& problem) {
  std::vector<char> averaged;
  for (const DynamicsBody& body : problem.bodies) {
    averaged.push_back(averages_dilatation(settings, body.material));
  }
  if (std::ranges::any_of(averaged, [](char one) { return one != 0; })) {
    dilatation = std::make_unique<CellDilatation<Dim>>(std::move(averaged));
  }
  with_transfer(shape, settings.transfer, [&]<class Shape, VelocityTransfer transfer>() {
    moves_with_mean = !is_affine<transfer, Shape>;
  });
  if (!moves_with_mean) {
    affine = std::make_unique<PointArray>(points, Dim * Dim);
    carried = std::make_unique<PointArray>(points, Dim);
  }
  if (std::ranges::any_of(materials, [](const auto& one) { return parts(one.law); })) {
    opened = std::make_unique<PointArray>(points, 1);
  }
  if (nodes.fades()) {
    strain_rate = std::make_unique<PointArray>(points, 1);
  }
}

template <int Dim>
void DynamicsData<Dim>::start_points(const DynamicsProblem<Dim>& problem) {
  for (Index row = 0; row < points.size(); ++row) {
    const Index number = points.body()[row];
    require(number < static_cast<Index>(problem.bodies.size()), "point ", points.id()[row],
            " belongs to body ", number, ", momentum knows ", problem.bodies.size(), " bodies");
    const DynamicsBody& body = problem.bodies[number];
    require(points.volume()[row] > 0.0, "point ", points.id()[row],
            " needs a positive volume, has ", points.volume()[row]);
    mass[row] = materials[number].density * points.volume()[row];
    Vec3 place = Vec3::Zero();
    for (int axis = 0; axis < Dim; ++axis) {
      place[axis] = points.position()[row * Dim + axis];
    }
    if (body.velocity) {
      const Vec3 start = body.velocity(place);
      std::copy(start.data(), start.data() + Dim, velocity.data() + row * Dim);
      if (carried) {
        std::copy(start.data(), start.data() + Dim, carried->data() + row * Dim);
      }
    }
    if (body.stress) {
      const SymmetricTensor start = body.stress(place);
      std::copy(start.components.begin(), start.components.begin() + stress_components,
                stress.data() + row * stress_components);
    }
  }
}

template <int Dim>
void DynamicsData<Dim>::clear_nodes() {
  if (fields.is_single()) {
    nodes.clear(order.node_layers());
  } else {
    nodes.clear(fields.node_count());
  }
}

PointSums& PointSums::operator+=(const PointSums& other) {
  kinetic += other.kinetic;
  plastic += other.plastic;
  strain_work += other.strain_work;
  work_ahead += other.work_ahead;
  expansion += other.expansion;
  speed = std::max(speed, other.speed);
  wave_speed = std::max(wave_speed, other.wave_speed);
  strain = std::max(strain, other.strain);
  least_volume = std::min(least_volume, other.least_volume);
  outside = outside || other.outside;
  return *this;
}

template class DynamicsNodes<2>;
template class DynamicsNodes<3>;
template double full_cell(const DynamicsData<2>&);
template double full_cell(const DynamicsData<3>&);
template struct DynamicsData<2>;
template struct DynamicsData<3>;

}  // namespace lapilli
