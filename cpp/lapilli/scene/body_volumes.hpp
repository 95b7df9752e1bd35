#pragma once

#include <string>
#include <vector>

#include "lapilli/core/body_volume.hpp"
#include "lapilli/core/note.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

class Points;

/// The volumes of all bodies of a built scene: of the points as they are, of the shapes at the
/// start.
std::vector<BodyVolume> body_volumes(const Scene& scene, const Points& points);

/// The same for points as they were built, without measuring shapes again whose parts the points
/// are.
std::vector<BodyVolume> body_volumes_at_start(const Scene& scene, const Points& points);

/// A warning for each body whose points hold over 0.1 % more or less than its shape.
std::vector<Note> volume_warnings(const std::vector<BodyVolume>& volumes, int dimension);

/// A warning for each body given by points whose volumes overlap: they hold over 1.5 times the box
/// around them.
std::vector<Note> packing_warnings(const Scene& scene, const Points& points);

}  // namespace lapilli
