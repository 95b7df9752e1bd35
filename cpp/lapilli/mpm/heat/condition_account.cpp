#include "lapilli/mpm/heat/condition_account.hpp"

#include <cmath>

namespace lapilli {

void ConditionAccount::book(std::size_t condition, double heat) {
  auto& [sum, dropped] = sums_[condition];
  const double total = sum + heat;
  dropped += std::abs(sum) >= std::abs(heat) ? (sum - total) + heat : (heat - total) + sum;
  sum = total;
}

void ConditionAccount::book(std::span<const double> heat, double total) {
  std::size_t largest = 0;
  for (std::size_t k = 0; k < heat.size(); ++k) {
    total -= heat[k];
    largest = std::abs(heat[k]) > std::abs(heat[largest]) ? k : largest;
  }
  for (std::size_t k = 0; k < heat.size(); ++k) {
    book(k, k == largest ? heat[k] + total : heat[k]);
  }
}

void ConditionAccount::extrapolate(const ConditionAccount& coarse) {
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const Sum& other = coarse.sums_[k];
    book(k, (sums_[k].sum - other.sum) + (sums_[k].dropped - other.dropped));
  }
}

std::vector<Balance::Entry> ConditionAccount::entries(
    std::span<const HeatBoundary> conditions) const {
  std::vector<Balance::Entry> all;
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    all.push_back({name_of_law(conditions[k], k), sums_[k].sum + sums_[k].dropped});
  }
  return all;
}

void ConditionAccount::save(Archive& archive, const std::string& name) const {
  std::vector<double> numbers;
  for (const Sum& one : sums_) {
    numbers.push_back(one.sum);
    numbers.push_back(one.dropped);
  }
  archive.write(name, std::span<const double>(numbers));
}

void ConditionAccount::load(const Archive& archive, const std::string& name) {
  std::vector<double> numbers(2 * sums_.size());
  archive.read(name, std::span<double>(numbers));
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    sums_[k] = {numbers[2 * k], numbers[2 * k + 1]};
  }
}

}  // namespace lapilli
