#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {

Tree TreeWriter::write_number(double number, const Key& key, const std::string& path) const {
  if (!std::isfinite(number) && !(key.infinity_allowed && std::isinf(number))) {
    require(in_memory_ == InMemory::named, path, " is ", number, ", which no scene file may hold");
    return {message(number), {}};
  }
  return {number, {}};
}

Tree TreeWriter::write_value(const Value& value, const Key& key, const std::string& path) const {
  if (value.is_function()) {
    return no_file_form(path, "function");
  }
  if (value.is_constant()) {
    return write_number(value.at(0.0), key, path);
  }
  const auto& in_time = std::get<Table>(value.form());
  return {Tree::Table{
              {"times", {}, write(in_time.times, Key("times"), joined_path(path, "times"))},
              {"values", {}, write(in_time.values, Key("values"), joined_path(path, "values"))}},
          {}};
}

Tree TreeWriter::write_tensor(const SymmetricTensor& tensor, const Key& key,
                              const std::string& path) const {
  if (tensor.is_scalar()) {
    return write_number(tensor[0], key, path);
  }
  Tree::Array components;
  for (int k = 0; k < 6; ++k) {
    components.push_back(write_number(tensor[k], key, path));
  }
  return {std::move(components), {}};
}

Tree TreeWriter::write_table(const TemperatureTable& table, const std::string& path) const {
  const auto list = [&](const char* name, const std::vector<double>& numbers) {
    return Tree::Entry{name, {}, write(numbers, Key(name), joined_path(path, name))};
  };
  return {Tree::Table{list("temperatures", table.temperatures), list("values", table.values)}, {}};
}

Tree TreeWriter::with_kind(const char* kind, Tree::Table members) {
  members.insert(members.begin(), {"kind", {}, {std::string(kind), {}}});
  return {std::move(members), {}};
}

void TreeWriter::MemberWriter::add(const Key& key, Tree tree) {
  const Tree::Entry* unchanged = find(defaults_, key.name);
  if (!tree.is_absent() && (key.is_required || !unchanged || !same(tree, unchanged->value))) {
    table_.push_back({key.name, {}, std::move(tree)});
  }
}

Tree TreeWriter::no_file_form(const std::string& path, const char* what) const {
  require(in_memory_ == InMemory::named, path, " is given as ", what,
          ", which a scene file cannot hold");
  return {std::string(what), {}};
}

}  // namespace lapilli
