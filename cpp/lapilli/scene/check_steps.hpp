#pragma once

#include "lapilli/core/simulation.hpp"
#include "lapilli/scene/check.hpp"

namespace lapilli {

/// Take the first steps of a simulation, and say how many it takes in all and how long.
void measure_steps(const Scene& scene, Simulation& simulation, CheckReport& report);

/// Steps from `begin` to the end of the scene that are `size` long but end at frames.
double steps_until_end(const Scene& scene, double begin, double size);

/// A number of steps as an integer counts them, at most 9e18.
Index whole_steps(double steps);

}  // namespace lapilli
