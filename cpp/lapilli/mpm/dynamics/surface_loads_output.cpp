// What loads on surfaces gave, and where they act.
#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/surface_loads.hpp"

namespace lapilli {

template <int Dim>
FieldAreas<Dim> SurfaceLoads<Dim>::areas_of_fields() const {
  FieldAreas<Dim> areas;
  for (int axis = 0; axis < Dim; ++axis) {
    areas.along[axis] = scratch_[1 + axis].data();
  }
  return areas;
}

template <int Dim>
double SurfaceLoads<Dim>::area_of(std::size_t law) const {
  double sum = 0.0;
  for (const double area : nodes_[law].area) {
    sum += std::abs(area);
  }
  return sum;
}

template <int Dim>
std::vector<Note> SurfaceLoads<Dim>::warnings() const {
  constexpr double kept = 0.8;  // share of the surface at the start
  std::vector<Note> all;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    const double now = area_of(law);
    if (region_of(laws_[law]) != nullptr && now < kept * start_area_[law]) {
      all.push_back(note("dynamics.region-left", "dynamics.boundaries.", law, " (",
                         name_of_law(laws_[law], law), ") acts on ",
                         std::llround(100.0 * now / start_area_[law]),
                         " % of the surface that it acted on at the start: its region stays "
                         "where it is, and the material has moved out of it"));
    }
  }
  return all;
}

template <int Dim>
double SurfaceLoads<Dim>::work() const {
  double sum = 0.0;
  for (const double work : work_) {
    sum += work;
  }
  return sum;
}

template <int Dim>
std::vector<Balance::Entry> SurfaceLoads<Dim>::work_entries() const {
  std::vector<Balance::Entry> entries;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    entries.push_back({name_of_law(laws_[law], law), work_[law]});
  }
  return entries;
}

template <int Dim>
std::vector<Balance::Entry> SurfaceLoads<Dim>::impulse_entries(int axis) const {
  std::vector<Balance::Entry> entries;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    entries.push_back({name_of_law(laws_[law], law), impulse_[law][axis]});
  }
  return entries;
}

template <int Dim>
SurfaceView SurfaceLoads<Dim>::surface() const {
  SurfaceView view;
  view.dimension = Dim;
  for (const Nodes& nodes : nodes_) {
    view.append(nodes);
  }
  return view;
}

#define LAPILLI_INSTANTIATE(Dim)                                                      \
  template FieldAreas<Dim> SurfaceLoads<Dim>::areas_of_fields() const;                \
  template double SurfaceLoads<Dim>::area_of(std::size_t) const;                      \
  template std::vector<Note> SurfaceLoads<Dim>::warnings() const;                     \
  template double SurfaceLoads<Dim>::work() const;                                    \
  template std::vector<Balance::Entry> SurfaceLoads<Dim>::work_entries() const;       \
  template std::vector<Balance::Entry> SurfaceLoads<Dim>::impulse_entries(int) const; \
  template SurfaceView SurfaceLoads<Dim>::surface() const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
