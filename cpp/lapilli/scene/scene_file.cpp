#include "lapilli/scene/scene_file.hpp"

#include <filesystem>

#include "lapilli/output/file.hpp"
#include "lapilli/scene/emit.hpp"
#include "lapilli/scene/toml_source.hpp"
#include "lapilli/scene/tree_reader.hpp"

namespace lapilli {

Scene parse_scene(std::string_view text, const std::string& name) {
  auto places = std::make_shared<Places>();
  places->source = name;
  Scene scene;
  TreeReader reader(*places);
  reader.read_struct(parse_toml(text, name), "", scene);
  reader.throw_mistakes();
  scene.places = std::move(places);
  return scene;
}

Scene load_scene(const std::string& path) { return parse_scene(read_text(path), path); }

std::string to_toml(const Scene& scene, Members members) {
  return emit_toml({TreeWriter(members).write_struct(scene, ""), {}});
}

void save_scene(const Scene& scene, const std::string& path, Members members) {
  write_whole(path, to_toml(scene, members));
}

std::string to_json(const Scene& scene) {
  return emit_json({TreeWriter(Members::all, InMemory::named).write_struct(scene, ""), {}});
}

std::string directory_of(const Scene& scene) {
  return scene.places ? std::filesystem::path(scene.places->source).parent_path().string()
                      : std::string();
}

}  // namespace lapilli
