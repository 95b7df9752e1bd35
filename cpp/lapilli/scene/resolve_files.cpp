#include "lapilli/scene/resolve_files.hpp"

#include <filesystem>

#include "lapilli/scene/member_types.hpp"
#include "lapilli/scene/scene_file.hpp"

namespace lapilli {
namespace {

// Whether a type may hold the name of a file somewhere.
template <class T>
inline constexpr bool holds_texts =
    std::is_same_v<T, std::string> || Kinded<T> || Indirect<T> || Described<T>;
template <class T>
inline constexpr bool holds_texts<std::optional<T>> = holds_texts<T>;
template <class T>
inline constexpr bool holds_texts<std::vector<T>> = holds_texts<T>;

/// Calls `change` with every name of a file that a scene holds.
template <class Change>
struct EachFile {
  Change change;

  template <class T>
  void operator()(const Key& key, T& member) {
    if constexpr (!holds_texts<T>) {
      return;
    } else if constexpr (std::is_same_v<T, std::string>) {
      if (key.names_file && !member.empty()) {
        change(member);
      }
    } else if constexpr (is_optional<T>) {
      if (member) {
        (*this)(key, *member);
      }
    } else if constexpr (is_vector<T>) {
      for (auto& element : member) {
        (*this)(key, element);
      }
    } else if constexpr (Indirect<T>) {
      if (!member.empty()) {
        Held<T> held = *member;
        (*this)(key, held);
        member = T(std::move(held));
      }
    } else if constexpr (Kinded<T>) {
      std::visit([&](auto& alternative) { (*this)(key, alternative); }, variant_of(member));
    } else {
      T::describe(member, *this);
    }
  }
};

template <class Change>
void each_file(Scene& scene, const Change& change) {
  EachFile<Change> visitor{change};
  Scene::describe(scene, visitor);
}

}  // namespace

Scene with_resolved_files(Scene scene) {
  const std::string folder = directory_of(scene);
  if (!folder.empty()) {
    each_file(scene, [&](std::string& name) {
      // An absolute name stays as it is: the files of a scene may be resolved twice.
      name = std::filesystem::absolute(std::filesystem::path(folder) / name).string();
    });
  }
  return scene;
}

std::vector<std::string> input_files(const Scene& scene) {
  std::vector<std::string> names;
  Scene changed = scene;
  each_file(changed, [&](const std::string& name) { names.push_back(name); });
  return names;
}

}  // namespace lapilli
