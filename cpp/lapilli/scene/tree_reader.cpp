#include "lapilli/scene/tree_reader.hpp"

#include <cmath>
#include <filesystem>

#include "lapilli/core/allowed.hpp"
#include "lapilli/core/renamed.hpp"
#include "lapilli/geometry/number_rows.hpp"

namespace lapilli {
namespace {

bool number_of(const Tree& tree, double& number) {
  if (const auto* integer = std::get_if<Index>(&tree.value)) {
    number = static_cast<double>(*integer);
    return true;
  }
  const auto* real = std::get_if<double>(&tree.value);
  number = real ? *real : 0.0;
  return real != nullptr;
}

}  // namespace

std::string place_text(const Places* places, std::string path) {
  if (!places) {
    return "";
  }
  while (true) {
    const auto found = places->at.find(path);
    if (found != places->at.end() && found->second.line > 0) {
      return message(places->source, ":", found->second.line, ":", found->second.column, ": ");
    }
    if (path.empty()) {
      return places->source.empty() ? "" : places->source + ": ";
    }
    const std::size_t last = path.find_last_of(".[");
    path.resize(last == std::string::npos ? 0 : last);
  }
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& allowed) {
  if (const std::string now = new_name(word, allowed); !now.empty()) {
    return "; it is called '" + now + "' now";
  }
  // Distances to words of any length would cost their product.
  const std::string near = word.size() <= 64 ? nearest_name(word, allowed) : std::string();
  return (near.empty() ? "; allowed: " : "; did you mean '" + near + "'? allowed: ") +
         joined(allowed);
}

void TreeReader::fail(Place place, const std::string& path, const std::string& what) const {
  const std::string where = place.line > 0
                                ? message(places_.source, ":", place.line, ":", place.column, ": ")
                            : places_.source.empty() ? std::string()
                                                     : places_.source + ": ";
  throw std::invalid_argument(where + path + (path.empty() ? "" : " ") + what);
}

void TreeReader::check_in_range(const Tree& tree, const Key& key, const std::string& path,
                                double number) const {
  const std::string mistake = range_mistake(key, number);
  if (!mistake.empty()) {
    fail(tree, path, mistake);
  }
}

void TreeReader::read_number(const Tree& tree, const Key& key, const std::string& path,
                             double& number) const {
  if (!number_of(tree, number)) {
    const std::string word =
        *key.absent_word ? message(" or \"", key.absent_word, "\"") : std::string();
    fail(tree, path,
         message("must be a number", *key.of_unit ? " in " : "", key.of_unit, word, ", got ",
                 in_words(tree)));
  }
  check_in_range(tree, key, path, number);
}

void TreeReader::read_integer(const Tree& tree, const Key& key, const std::string& path,
                              Index& number) const {
  const auto* integer = std::get_if<Index>(&tree.value);
  if (!integer) {
    fail(tree, path, message("must be an integer, got ", in_words(tree)));
  }
  check_in_range(tree, key, path, static_cast<double>(*integer));
  number = *integer;
}

void TreeReader::read_text(const Tree& tree, const Key&, const std::string& path,
                           std::string& text) const {
  if (!tree.string()) {
    fail(tree, path, message("must be a text in quotes, got ", in_words(tree)));
  }
  text = *tree.string();
  if (text.find('\0') != std::string::npos) {
    fail(tree, path, "must not contain a null character");
  }
}

// A table in time from two columns of a text file, named from the folder of the scene.
Table TreeReader::table_of_file(const Tree::Table& table, const Tree::Entry& file, const Key& key,
                                const std::string& path) {
  const std::string file_path = joined_path(path, "file");
  if (table.size() > 1) {
    fail(file.value, file_path, "holds times and values: give a file or lists, not both");
  }
  const std::string* name = file.value.string();
  if (!name) {
    fail(file.value, file_path, message("must name a file, got ", in_words(file.value)));
  }
  const auto folder = std::filesystem::path(places_.source).parent_path();
  TwoColumns columns;
  try {
    columns = read_two_columns((folder / *name).string());
  } catch (const std::invalid_argument& error) {
    fail(file.value, file_path, error.what());
  }
  for (std::size_t k = 0; k < columns.first.size(); ++k) {
    double number = 0.0;
    read_number({columns.second[k], file.place}, key, message(file_path, ", row ", k), number);
    if (k > 0 && columns.first[k] < columns.first[k - 1]) {
      fail(file.value, file_path, message("has times that decrease in row ", k));
    }
  }
  return {std::move(columns.first), std::move(columns.second)};
}

void TreeReader::read_columns(const Tree& tree, const Key& by, const Key& key,
                              const std::string& path, std::vector<double>& places,
                              std::vector<double>& values) const {
  for (const auto& [name, numbers, each] :
       {std::tuple(by.name, &places, by), std::tuple("values", &values, key)}) {
    const std::string list_path = joined_path(path, name);
    const Tree::Entry* entry = find(*tree.table(), name);
    if (!entry) {
      fail(tree, list_path, "is missing");
    }
    const Tree::Array* list = entry->value.array();
    if (!list || list->empty()) {
      fail(entry->value, list_path,
           message("must be a list of numbers, got ", in_words(entry->value)));
    }
    for (std::size_t k = 0; k < list->size(); ++k) {
      read_number((*list)[k], each, element_path(list_path, k), numbers->emplace_back());
    }
  }
  if (places.size() != values.size()) {
    fail(tree, path,
         message("needs as many values as ", by.name, ", got ", values.size(), " and ",
                 places.size()));
  }
}

TemperatureTable TreeReader::read_temperature_table(const Tree& tree, const Key& key,
                                                    const std::string& path) {
  check_known(*tree.table(), path, {"temperatures", "values"});
  TemperatureTable read;
  read_columns(tree, Key("temperatures").unit("K"), key, path, read.temperatures, read.values);
  if (const std::string mistake = mistake_in(read); !mistake.empty()) {
    fail(tree, path, mistake);
  }
  return read;
}

void TreeReader::read_value(const Tree& tree, const Key& key, const std::string& path,
                            Value& value) {
  double number = 0.0;
  if (number_of(tree, number)) {
    read_number(tree, key, path, number);
    value = Value(number);
    return;
  }
  const Tree::Table* table = tree.table();
  if (!table) {
    fail(tree, path,
         message("must be a number", *key.of_unit ? " in " : "", key.of_unit,
                 " or a table in time {times = [...], values = [...]} or {file = \"...\"}, got ",
                 in_words(tree)));
  }
  check_known(*table, path, {"times", "values", "file"});
  if (const Tree::Entry* file = find(*table, "file")) {
    value = Value(table_of_file(*table, *file, key, path));
    return;
  }
  Table in_time;
  read_columns(tree, Key("times").unit("s"), key, path, in_time.times, in_time.values);
  if (!in_time.is_ordered()) {
    fail(tree, joined_path(path, "times"), "must increase; two equal times, not three, are a jump");
  }
  value = Value(std::move(in_time));
}

void TreeReader::read_tensor(const Tree& tree, const Key& key, const std::string& path,
                             SymmetricTensor& tensor) const {
  double number = 0.0;
  if (number_of(tree, number)) {
    read_number(tree, key, path, number);
    tensor = SymmetricTensor(number);
    return;
  }
  const Tree::Array* list = tree.array();
  if (!list || list->size() != 6) {
    fail(tree, path,
         message("must be a number or the six components xx, yy, zz, xy, yz, xz, got ",
                 in_words(tree)));
  }
  for (int k = 0; k < 6; ++k) {
    read_number((*list)[static_cast<std::size_t>(k)], key,
                element_path(path, static_cast<std::size_t>(k)), tensor[k]);
  }
}

const Tree::Table& TreeReader::table_of(const Tree& tree, const std::string& path) const {
  const Tree::Table* table = tree.table();
  if (!table) {
    fail(tree, path, message("must be a table, got ", in_words(tree)));
  }
  return *table;
}

void TreeReader::fail_name(const Tree& tree, const std::string& path,
                           const std::vector<std::string>& allowed) const {
  const std::string* word = tree.string();
  if (!word) {
    fail(tree, path, message("must be one of ", joined(allowed), ", got ", in_words(tree)));
  }
  fail(tree, path, message("knows no '", *word, "'", suggestion(*word, allowed)));
}

std::string TreeReader::kind_of(const Tree& tree, const std::string& path,
                                const std::vector<std::string>& allowed) const {
  const Tree::Entry* kind = find(table_of(tree, path), "kind");
  const std::string kind_path = joined_path(path, "kind");
  if (!kind) {
    fail(tree, kind_path, message("is missing: which of ", joined(allowed), " it is"));
  }
  std::string word;
  read_text(kind->value, Key("kind"), kind_path, word);
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end()) {
    fail(kind->value, kind_path, message("knows no '", word, "'", suggestion(word, allowed)));
  }
  return word;
}

const Tree* TreeReader::MemberReader::find_value(const Key& key, const std::string& path) {
  if (const Tree::Entry* entry = find(table_, key.name)) {
    reader_.places_.at[path] = entry->place;
    return &entry->value;
  }
  if (key.is_required &&
      std::find(misspelt_.begin(), misspelt_.end(), key.name) == misspelt_.end()) {
    reader_.mistakes_.gather([&] {
      reader_.fail(tree_, path,
                   message("is missing", *key.meaning ? ": " : "", key.meaning,
                           *key.of_unit ? " in " : "", key.of_unit));
    });
  }
  return nullptr;
}

void TreeReader::check_length(const Tree& tree, const Key& key, const std::string& path,
                              std::size_t length) const {
  const auto count = static_cast<Index>(length);
  if (count < key.shortest || count > key.longest) {
    fail(tree, path, message("must hold ", allowed_length(key), ", got ", length));
  }
}

std::vector<std::string> TreeReader::check_known(const Tree::Table& table, const std::string& path,
                                                 const std::vector<std::string>& allowed) {
  std::vector<std::string> meant;
  for (const Tree::Entry& entry : table) {
    if (std::find(allowed.begin(), allowed.end(), entry.name) != allowed.end()) {
      continue;
    }
    const std::string entry_path = joined_path(path, entry.name);
    const std::string now = new_name(entry.name, allowed);
    mistakes_.gather([&] {
      fail(entry.place, entry_path,
           now.empty() ? "is no known key" + suggestion(entry.name, allowed)
                       : "is called '" + now + "' now");
    });
    meant.push_back(entry.name.size() <= 64 ? nearest_name(entry.name, allowed) : "");
  }
  return meant;
}

}  // namespace lapilli
