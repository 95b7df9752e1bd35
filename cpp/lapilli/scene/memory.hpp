#pragma once

#include <string>

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// What a scene takes, known before anything is made.
struct SizeEstimate {
  double nodes = 0.0;
  double points = 0.0;
  double memory = 0.0;  // bytes
  std::string stage;    // of which stage; empty: the first, or the scene has none
};

/// From the grid, and from the shapes at a few thousand sampled places. Reads the files that shapes
/// name; allocates nothing of the scene's size.
SizeEstimate size_of(const Scene& scene);

/// The same of the stage that takes the most memory.
SizeEstimate largest_size_of(const Scene& scene);

/// Bytes of a simulation with so many nodes and points, from the sizes of its arrays.
double memory_of(const Scene& scene, double nodes, double points);

/// Throw std::invalid_argument when a body or a wall reaches far outside of the grid, before it is
/// filled with points, and when the scene or a stage of it needs more
/// memory than there is.
void require_feasible(const Scene& scene);

}  // namespace lapilli
