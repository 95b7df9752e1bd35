#include "lapilli/mpm/dynamics/plastic_heat.hpp"

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {

PlasticHeat::PlasticHeat(Points& points, PointArray& work, PointArray& temperature,
                         const PointArray& capacity, std::vector<double> shares, Book book)
    : points_(points),
      work_(work),
      temperature_(temperature),
      capacity_(capacity),
      shares_(std::move(shares)),
      book_(std::move(book)) {
  for (const double share : shares_) {
    require(share >= 0.0 && share <= 1.0, "plastic heating: share must lie in [0, 1], got ", share);
  }
  for (const Index body : points.body()) {
    require(body < static_cast<Index>(shares_.size()), "plastic heating knows ", shares_.size(),
            " bodies, points belong to body ", body);
  }
}

StepReport PlasticHeat::advance(const Step& step) {
  book_(parallel_sum(points_.size(), 0.0, [&](Index row) {
    const double heat = shares_[points_.body()[row]] * work_[row];
    work_[row] = 0.0;
    temperature_[row] += heat / capacity_[row];
    return heat;
  }));
  StepReport report;
  report.accepted = step.size;
  return report;
}

}  // namespace lapilli
