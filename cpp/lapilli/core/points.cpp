#include "lapilli/core/points.hpp"

#include <algorithm>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

template <class T>
void reorder(std::span<T> values, int components, std::span<const Index> order,
             std::vector<T>& scratch) {
  scratch.resize(values.size());
  parallel_for(static_cast<Index>(order.size()), [&](Index row) {
    const T* from = values.data() + order[row] * components;
    std::copy(from, from + components, scratch.data() + row * components);
  });
  std::copy(scratch.begin(), scratch.end(), values.begin());
}

}  // namespace

Points::Points(int dimension) : dimension_(dimension) {
  require(dimension >= 1 && dimension <= 3, "points have 1, 2 or 3 dimensions, got ", dimension);
}

void Points::append(std::span<const double> positions, std::span<const double> volumes, int body) {
  require(positions.size() == volumes.size() * static_cast<std::size_t>(dimension_),
          "positions have ", positions.size(), " numbers, ", volumes.size(),
          " points of dimension ", dimension_, " need ",
          volumes.size() * static_cast<std::size_t>(dimension_));
  require(attached_.empty(), "points can be added only before a physics attaches its arrays");
  position_.insert(position_.end(), positions.begin(), positions.end());
  volume_.insert(volume_.end(), volumes.begin(), volumes.end());
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    id_.push_back(static_cast<Index>(id_.size()));
    body_.push_back(body);
  }
}

void Points::permute(std::span<const Index> order) {
  std::vector<double> scratch;
  std::vector<Index> index_scratch;
  reorder<double>(position_, dimension_, order, scratch);
  reorder<double>(volume_, 1, order, scratch);
  reorder<Index>(id_, 1, order, index_scratch);
  reorder<Index>(body_, 1, order, index_scratch);
  for (PointArray* array : attached_) {
    reorder<double>(array->values(), array->components(), order, scratch);
  }
  ++ordering_;
}

void Points::save(Archive& archive) const {
  archive.write("points/position", position_);
  archive.write("points/volume", volume_);
  archive.write("points/id", id_);
  archive.write("points/body", body_);
}

void Points::load(const Archive& archive) {
  archive.read("points/position", position_);
  archive.read("points/volume", volume_);
  archive.read("points/id", id_);
  archive.read("points/body", body_);
  ++ordering_;
  moved();
}

bool Points::carry_gradients() const {
  return std::ranges::any_of(attached_, [](const PointArray* array) {
    return array->kind() == PointArray::Kind::gradient;
  });
}

void Points::attach(PointArray* array) { attached_.push_back(array); }

void Points::detach(PointArray* array) { std::erase(attached_, array); }

PointArray::PointArray(Points& points, int components, double value, Kind kind)
    : points_(points),
      components_(components),
      kind_(kind),
      values_(static_cast<std::size_t>(points.size() * components), value) {
  points_.attach(this);
}

PointArray::~PointArray() { points_.detach(this); }

}  // namespace lapilli
