#include "lapilli/mpm/surface/area_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace lapilli {
namespace {

// Beyond these the nodes have found another surface than that of the shape; a part of it smaller
// than a cell is found many times too large.
double ratio_of(double wanted, double found) {
  constexpr double most = 3.0, least = 1e-3;
  const double ratio = wanted / found;
  return ratio > least && ratio < most ? ratio : 1.0;
}

}  // namespace

AreaRatios::AreaRatios(const ShapeAreas& wanted,
                       const std::function<Found(const std::vector<std::size_t>&)>& found_of) {
  const std::size_t bodies = wanted.whole.size(), conditions = wanted.conditions();
  of_body_.assign(bodies, 1.0);
  found_.assign(conditions, 0.0);
  std::vector<double> shapes(conditions, 0.0), as_found(conditions, 0.0);
  for (const std::vector<std::size_t>& group : groups_of(wanted.touching)) {
    const Found found = found_of(group);
    double whole = 0.0;
    for (const std::size_t body : group) {
      whole += wanted.whole[body];
    }
    const double ratio = ratio_of(whole, found.whole);
    for (const std::size_t body : group) {
      of_body_[body] = ratio;
    }
    for (std::size_t condition = 0; condition < conditions; ++condition) {
      found_[condition] += ratio * found.by_condition[condition];
      as_found[condition] += found.by_condition[condition];
      for (const std::size_t body : group) {
        shapes[condition] += wanted.by_condition[body][condition];
      }
    }
  }
  for (std::size_t condition = 0; condition < conditions; ++condition) {
    patch_.push_back(ratio_of(shapes[condition], found_[condition]));
    at_start_.push_back(ratio_of(shapes[condition], as_found[condition]));
  }
}

template <int Dim>
void AreaRatios::scale(NodalAreas<Dim>& areas, const OutsideCells<Dim>& cells) const {
  if (of_body_.empty()) {
    return;
  }
  const bool alike = std::all_of(of_body_.begin(), of_body_.end(),
                                 [&](double ratio) { return ratio == of_body_.front(); });
  for (std::size_t row = 0; row < areas.node.size(); ++row) {
    const int body = alike ? 0 : cells.body_beside(areas.node[row]);
    const double ratio = body < 0 ? 1.0 : of_body_[static_cast<std::size_t>(body)];
    areas.area[row] *= ratio;
    areas.positive[row] *= ratio;
  }
}

void AreaRatios::scale(std::size_t condition, std::span<double> area) const {
  if (patch_.empty()) {
    return;
  }
  const double before = found_[condition];
  const double now = std::accumulate(area.begin(), area.end(), 0.0);
  const double share = now > before ? before / now : 1.0;
  const double ratio = 1.0 + (patch_[condition] - 1.0) * share * share;
  for (double& part : area) {
    part *= ratio;
  }
}

double AreaRatios::farthest() const {
  double farthest = 1.0;
  for (const double ratio : at_start_) {
    farthest = std::abs(ratio - 1.0) > std::abs(farthest - 1.0) ? ratio : farthest;
  }
  return farthest;
}

void AreaRatios::save(Archive& archive, const std::string& name) const {
  archive.write(name + "/bodies", of_body_);
  archive.write(name + "/patches", patch_);
  archive.write(name + "/found", found_);
  archive.write(name + "/at_start", at_start_);
}

void AreaRatios::load(const Archive& archive, const std::string& name) {
  of_body_ = archive.read_numbers(name + "/bodies");
  patch_ = archive.read_numbers(name + "/patches");
  found_ = archive.read_numbers(name + "/found");
  at_start_ = archive.read_numbers(name + "/at_start");
}

AreaRatios AreaRatios::of_before(const Archive& archive, const std::string& name,
                                 const std::vector<int>& body, const std::vector<int>& condition) {
  const auto pick = [](const std::vector<double>& before, const std::vector<int>& numbers,
                       double otherwise) {
    std::vector<double> values;
    for (const int number : numbers) {
      values.push_back(before.empty() || number < 0 ? otherwise
                                                    : before.at(static_cast<std::size_t>(number)));
    }
    return values;
  };
  AreaRatios before, now;
  before.load(archive, name);
  now.of_body_ = pick(before.of_body_, body, 1.0);
  now.patch_ = pick(before.patch_, condition, 1.0);
  now.found_ = pick(before.found_, condition, 0.0);
  now.at_start_ = pick(before.at_start_, condition, 1.0);
  return now;
}

std::unique_ptr<Points> points_of(const Points& points, const std::vector<std::size_t>& bodies) {
  auto some = std::make_unique<Points>(points.dimension());
  const auto dimension = static_cast<std::size_t>(points.dimension());
  for (const std::size_t body : bodies) {
    std::vector<double> positions, volumes;
    for (Index row = 0; row < points.size(); ++row) {
      if (points.body()[row] == static_cast<Index>(body)) {
        const auto from = points.position().begin() + static_cast<Index>(dimension) * row;
        positions.insert(positions.end(), from, from + static_cast<Index>(dimension));
        volumes.push_back(points.volume()[row]);
      }
    }
    some->append(positions, volumes, static_cast<int>(body));
  }
  return some;
}

template void AreaRatios::scale(NodalAreas<1>&, const OutsideCells<1>&) const;
template void AreaRatios::scale(NodalAreas<2>&, const OutsideCells<2>&) const;
template void AreaRatios::scale(NodalAreas<3>&, const OutsideCells<3>&) const;

}  // namespace lapilli
