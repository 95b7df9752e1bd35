// Points that leave the grid and are removed.
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"
#include "lapilli/mpm/dynamics/mover.hpp"

namespace lapilli {

/// A position that is not finite is a broken step, not a way out.
template <int Dim>
void Dynamics<Dim>::find_outside() {
  std::vector<Index> rows;
  for (Index row = 0; row < data_.points.size(); ++row) {
    const Vec<Dim> place = data_.points.template position<Dim>(row);
    if (!data_.grid.contains(place)) {
      if (!place.allFinite()) {
        require_inside(data_.grid, data_.points);
      }
      rows.push_back(row);
    }
  }
  data_.points.leave(std::move(rows));
}

/// A point that would leave in the first half of a step waits at the face for the second: gravity
/// moves it on with the nodes meanwhile. That belongs to what it takes along.
template <int Dim>
void Dynamics<Dim>::book_waiting(double step) {
  const Vec<Dim> gravity = data_.gravity.template head<Dim>();
  if (data_.settings.outside == Outside::stop || !data_.carried || gravity.isZero(0.0)) {
    return;
  }
  const Mover<Dim> move(data_, 0.5 * step);
  removed_.energy -= parallel_sum(data_.points.size(), 0.0, [&](Index row) {
    const double* carried = data_.carried->data() + row * Dim;
    const Vec<Dim> start = data_.points.template position<Dim>(row);
    Vec<Dim> held = start, free = start;
    move.drift(held.data(), carried);
    if (move(free.data(), carried)) {
      return 0.0;
    }
    return data_.mass[row] * gravity.dot(free - held);
  });
}

template <int Dim>
std::vector<double> Dynamics<Dim>::stored_in(std::span<const Index> rows) const {
  const Vec<Dim> gravity = data_.gravity.template head<Dim>();
  std::vector<double> stored(1 + Dim, 0.0);
  for (const Index row : rows) {
    const double height = gravity.dot(data_.points.template position<Dim>(row));
    stored[0] += kinetic_energy_of(row) - data_.mass[row] * height + elastic_energy_of(row);
    for (int axis = 0; axis < Dim; ++axis) {
      stored[1 + axis] += data_.mass[row] * data_.velocity[row * Dim + axis];
    }
  }
  return stored;
}

template <int Dim>
void Dynamics<Dim>::release(std::span<const Index> rows) {
  const Vec<Dim> gravity = data_.gravity.template head<Dim>();
  for (const Index row : rows) {
    const double mass = data_.mass[row], kinetic = kinetic_energy_of(row);
    const double height = gravity.dot(data_.points.template position<Dim>(row));
    removed_.points += 1.0;
    removed_.mass += mass;
    removed_.energy += kinetic - mass * height + elastic_energy_of(row);
    removed_.momentum.template head<Dim>() +=
        mass * Eigen::Map<const Vec<Dim>>(data_.velocity.data() + row * Dim);
    kinetic_ -= kinetic;
    total_mass_ -= mass;
  }
}

template <int Dim>
void Dynamics<Dim>::save_removed(Archive& archive) const {
  if (data_.settings.outside == Outside::remove) {
    const double numbers[] = {removed_.points,      removed_.mass,        removed_.energy,
                              removed_.momentum[0], removed_.momentum[1], removed_.momentum[2]};
    archive.write("dynamics/removed", std::span<const double>(numbers));
  }
}

template <int Dim>
void Dynamics<Dim>::load_removed(const Archive& archive) {
  if (data_.settings.outside == Outside::remove) {
    double numbers[6];
    archive.read("dynamics/removed", std::span<double>(numbers));
    removed_ = {numbers[0], numbers[1], numbers[2], {numbers[3], numbers[4], numbers[5]}};
  }
}

template <int Dim>
std::vector<Note> Dynamics<Dim>::warnings() const {
  std::vector<Note> all = lapilli::warnings(data_.settings);
  if (data_.shape == ShapeFunction::bspline) {
    all.push_back(note(
        "dynamics.damping-bspline",
        "grid.shape_function bspline damps what vibrates, by a quarter of its energy in a hundred "
        "periods; gimp does not"));
  }
  all.insert(all.end(), start_notes_.begin(), start_notes_.end());
  const std::vector<Note> open = energy_looked_at().warnings();
  all.insert(all.end(), open.begin(), open.end());
  if (loads_) {
    const std::vector<Note> lost = loads_->warnings();
    all.insert(all.end(), lost.begin(), lost.end());
  }
  if (obstacles_) {
    const std::vector<Note> inside = obstacles_->warnings(data_);
    all.insert(all.end(), inside.begin(), inside.end());
  }
  if (removed_.points > 0.0) {
    all.push_back(note("dynamics.points-removed", removed_.points,
                       " points left the grid and were removed: ", removed_.mass, " kg",
                       Dim == 2 ? "/m" : "", " of ", removed_.mass + total_mass_));
  }
  return all;
}

template void Dynamics<2>::find_outside();
template void Dynamics<3>::find_outside();
template void Dynamics<2>::book_waiting(double);
template void Dynamics<3>::book_waiting(double);
template std::vector<double> Dynamics<2>::stored_in(std::span<const Index>) const;
template std::vector<double> Dynamics<3>::stored_in(std::span<const Index>) const;
template void Dynamics<2>::release(std::span<const Index>);
template void Dynamics<3>::release(std::span<const Index>);
template void Dynamics<2>::save_removed(Archive&) const;
template void Dynamics<3>::save_removed(Archive&) const;
template void Dynamics<2>::load_removed(const Archive&);
template void Dynamics<3>::load_removed(const Archive&);
template std::vector<Note> Dynamics<2>::warnings() const;
template std::vector<Note> Dynamics<3>::warnings() const;

}  // namespace lapilli
