#include "lapilli/scene/identity.hpp"

#include <algorithm>

#include "lapilli/geometry/file_bytes.hpp"
#include "lapilli/output/checksum.hpp"
#include "lapilli/output/json.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/stage_scenes.hpp"
#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {
namespace {

constexpr std::size_t longest_value = 100;  // characters; longer ones are told by their checksum

std::string text_of(const Tree& tree);

struct TextOf {
  std::string operator()(const Tree::Absent&) const { return ""; }
  std::string operator()(bool truth) const { return truth ? "true" : "false"; }
  std::string operator()(Index number) const { return std::to_string(number); }
  std::string operator()(double number) const { return shortest(number); }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(const Tree::Table&) const { return "a table"; }
  std::string operator()(const Tree::Foreign& foreign) const { return foreign.what; }
  std::string operator()(const Tree::Array& array) const {
    std::string text;
    for (const Tree& element : array) {
      text += (text.empty() ? "[" : ", ") + text_of(element);
    }
    return text.empty() ? "[]" : text + "]";
  }
};

std::string text_of(const Tree& tree) { return std::visit(TextOf{}, tree.value); }

/// Control characters would end the line; what is long is told apart by its sum.
std::string on_one_line(std::string text) {
  if (text.size() > longest_value) {
    text = message(text.substr(0, longest_value), "... (", text.size(), " characters, ",
                   fingerprint(text), ")");
  }
  for (char& character : text) {
    character = static_cast<unsigned char>(character) < ' ' ? ' ' : character;
  }
  return text;
}

bool holds_tables(const Tree::Array& array) {
  return std::any_of(array.begin(), array.end(),
                     [](const Tree& element) { return element.table() != nullptr; });
}

class Lines {
 public:
  void add(const std::string& key, const std::string& value) {
    identity_.lines += key + '\t' + on_one_line(value) + '\n';
  }
  void add(const std::string& path, const Tree& tree) {
    if (const Tree::Table* table = tree.table()) {
      for (const Tree::Entry& entry : *table) {
        add(joined_path(path, entry.name), entry.value);
      }
    } else if (const Tree::Array* array = tree.array(); array != nullptr && holds_tables(*array)) {
      for (std::size_t k = 0; k < array->size(); ++k) {
        add(joined_path(path, std::to_string(k)), (*array)[k]);
      }
    } else if (!tree.is_absent()) {
      if (tree.string() != nullptr && *tree.string() == "function") {
        identity_.not_compared.push_back(path);
      }
      add(path, text_of(tree));
    }
  }
  SceneIdentity take() { return std::move(identity_); }

 private:
  SceneIdentity identity_;
};

std::string in_words(const std::vector<double>& numbers) {
  const auto bytes = std::as_bytes(std::span(numbers));
  return message(numbers.size(), " numbers, ",
                 fingerprint({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
}

std::string file_in_words(const std::string& name) {
  try {
    const std::string bytes = read_bytes(name);
    return message(bytes.size(), " bytes, ", fingerprint(bytes));
  } catch (const std::invalid_argument&) {
    return "cannot be read";
  }
}

/// A run may go on to a later end of its last stage, unless that changes the steps.
void forget_last_end(Scene& scene) {
  const std::vector<StageScene> stages = stage_scenes(with_resolved_files(scene));
  if (!stages.back().scene.time.steps) {
    scene.stages.back().end = 0.0;
  }
}

std::vector<std::pair<std::string, std::string>> files_set_by_stages(const Scene& scene) {
  std::vector<std::pair<std::string, std::string>> all;
  if (scene.stages.empty()) {
    return all;
  }
  const Scene resolved = with_resolved_files(scene);
  const std::vector<std::string> known = input_files(resolved);
  for (const StageScene& stage : stage_scenes(resolved)) {
    for (const std::string& file : input_files(stage.scene)) {
      if (std::ranges::find(known, file) == known.end()) {
        all.emplace_back("file of stage " + stage.name, file);
      }
    }
  }
  return all;
}

}  // namespace

SceneIdentity identity_of(const Scene& given) {
  Scene scene = given;
  scene.title.clear();
  scene.output = {};
  scene.probes.clear();
  if (!scene.stages.empty()) {
    forget_last_end(scene);
  } else if (!scene.time.steps) {
    scene.time.end = 0.0;
  }
  Lines lines;
  lines.add("lapilli", std::string(LAPILLI_VERSION));
  lines.add("", {TreeWriter(Members::all, InMemory::named).write_struct(scene, ""), {}});
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    if (scene.bodies[body].points) {
      lines.add(message("bodies.", body, ".points (positions)"),
                in_words(scene.bodies[body].points->positions));
      lines.add(message("bodies.", body, ".points (volumes)"),
                in_words(scene.bodies[body].points->volumes));
    }
  }
  const std::vector<std::string> names = input_files(scene);
  const std::vector<std::string> resolved = input_files(with_resolved_files(scene));
  for (std::size_t file = 0; file < names.size(); ++file) {
    lines.add("file " + names[file], file_in_words(resolved[file]));
  }
  for (const auto& [key, file] : files_set_by_stages(given)) {
    lines.add(key, file_in_words(file));
  }
  return lines.take();
}

}  // namespace lapilli
