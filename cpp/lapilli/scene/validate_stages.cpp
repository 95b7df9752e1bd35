#include "lapilli/scene/validate_stages.hpp"

#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/stage_scenes.hpp"
#include "lapilli/scene/validate.hpp"

namespace lapilli {

void validate_stages(const Scene& scene) {
  if (scene.stages.empty()) {
    return;
  }
  const std::vector<StageScene> stages = stage_scenes(scene);
  for (std::size_t k = 1; k < stages.size(); ++k) {
    const std::string path = element_path("stages", k - 1);
    in_file(scene, path, [&] {
      try {
        validate(stages[k].scene);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(message(path, " '", stages[k].name, "': ", error.what()));
      }
    });
  }
}

}  // namespace lapilli
