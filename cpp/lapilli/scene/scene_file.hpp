#pragma once

#include <string>
#include <string_view>

#include "lapilli/scene/scene.hpp"
#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {

/// The scene of a TOML text; `name` is the file's name in messages. Throws std::invalid_argument
/// with file, line, key, what was given and what is allowed, a line for each of up to twenty
/// mistakes. What the keys mean together is checked by validate().
Scene parse_scene(std::string_view text, const std::string& name);

/// The scene of a TOML file.
Scene load_scene(const std::string& path);

/// The scene as TOML; reads back to the same scene, bit by bit. Throws std::invalid_argument by
/// name for functions and arrays, which no file holds.
std::string to_toml(const Scene& scene, Members members = Members::changed);

/// Write the scene as TOML, whole or not at all. Throws OutputError where that cannot be.
void save_scene(const Scene& scene, const std::string& path, Members members = Members::changed);

/// Every setting with defaults filled in, as JSON; functions and arrays are named, not shown.
std::string to_json(const Scene& scene);

/// Set one member by its path: "grid.cell=0.05", "bodies[0].points_per_cell=9",
/// "heat.boundaries[0].region={kind = \"disk\", radius = 2}". An index may also be a member of its
/// own, "bodies.0". The value is TOML; quotes around a
/// single word may be left out. Throws as a file's reader does.
void apply_override(Scene& scene, const std::string& assignment);

/// Set the member at a path to a value without places; elements of lists go by number, name or
/// kind. `label`, "--set: ", stands before messages.
void set_member(Scene& scene, const std::vector<std::string>& path, const Tree& value,
                const std::string& label);

/// The names of a path: "bodies[0].shape" and "bodies.0.shape" give bodies, 0, shape.
std::vector<std::string> path_names(const std::string& path);

/// The directory that relative file names of the scene start from; empty: the current one.
std::string directory_of(const Scene& scene);

}  // namespace lapilli
