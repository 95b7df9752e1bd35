#include "lapilli/core/stage_account.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace lapilli {
namespace {

void add(std::vector<Balance::Entry>& entries, const std::string& name, double in) {
  const auto found = std::ranges::find(entries, name, &Balance::Entry::name);
  if (found != entries.end()) {
    found->in += in;
  } else {
    entries.push_back({name, in});
  }
}

/// Names without line breaks, a line each.
class Lines {
 public:
  void add(const std::string& name) { text_ += name + "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

void StageAccount::close(const Balance& before, const std::string& next_stage,
                         const Change& change) {
  const auto [found, first] = balances_.try_emplace(before.quantity);
  Earlier& earlier = found->second;
  if (first) {
    earlier.initial = before.initial;
  }
  for (const Balance::Entry& entry : before.entries) {
    add(earlier.entries, entry.name, entry.in);
  }
  const std::string stage = "stage " + next_stage;
  if (change.removed != 0.0) {
    add(earlier.entries, stage + " removed", -change.removed);
  }
  if (change.added != 0.0) {
    add(earlier.entries, stage + " added", change.added);
  }
  add(earlier.entries, stage + " changed", change.left);
}

void StageAccount::add_to(Balance& balance) const {
  const auto found = balances_.find(balance.quantity);
  if (found == balances_.end()) {
    return;
  }
  balance.initial = found->second.initial;
  std::vector<Balance::Entry> all = found->second.entries;
  for (const Balance::Entry& entry : balance.entries) {
    add(all, entry.name, entry.in);
  }
  balance.entries = std::move(all);
}

double StageAccount::sum(const std::string& name) const {
  const auto found = sums_.find(name);
  return found == sums_.end() ? 0.0 : found->second;
}

void StageAccount::save(Archive& archive) const {
  Lines names, sums;
  std::vector<double> numbers, counted;
  for (const auto& [quantity, earlier] : balances_) {
    names.add(quantity);
    names.add(std::to_string(earlier.entries.size()));
    numbers.push_back(earlier.initial);
    for (const Balance::Entry& entry : earlier.entries) {
      names.add(entry.name);
      numbers.push_back(entry.in);
    }
  }
  for (const auto& [name, value] : sums_) {
    sums.add(name);
    counted.push_back(value);
  }
  archive.write("stage/balance_names", names.text());
  archive.write("stage/balances", std::span<const double>(numbers));
  archive.write("stage/sum_names", sums.text());
  archive.write("stage/sums", std::span<const double>(counted));
}

void StageAccount::load(const Archive& archive) {
  balances_.clear();
  sums_.clear();
  const std::vector<std::string> names = lines_of(archive.read_text("stage/balance_names"));
  const std::vector<double> numbers = archive.read_numbers("stage/balances");
  std::size_t name = 0, number = 0;
  while (name + 1 < names.size()) {
    Earlier& earlier = balances_[names[name]];
    const std::size_t entries = std::stoul(names[name + 1]);
    name += 2;
    earlier.initial = numbers.at(number++);
    for (std::size_t k = 0; k < entries; ++k) {
      earlier.entries.push_back({names.at(name++), numbers.at(number++)});
    }
  }
  const std::vector<std::string> sums = lines_of(archive.read_text("stage/sum_names"));
  const std::vector<double> counted = archive.read_numbers("stage/sums");
  for (std::size_t k = 0; k < sums.size(); ++k) {
    sums_[sums[k]] = counted.at(k);
  }
}

}  // namespace lapilli
