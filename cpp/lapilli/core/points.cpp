#include "lapilli/core/points.hpp"

#include <algorithm>
#include <numeric>

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

/// Close the gaps that the rows `gone` leave, without changing the size.
template <class T>
void close_gaps(std::span<T> values, int components, std::span<const Index> gone) {
  if (gone.empty()) {
    return;
  }
  auto to = values.begin() + gone.front() * components;
  for (std::size_t k = 0; k < gone.size(); ++k) {
    const auto from = values.begin() + (gone[k] + 1) * components;
    const auto end = k + 1 < gone.size() ? values.begin() + gone[k + 1] * components : values.end();
    to = std::copy(from, end, to);
  }
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
    id_.push_back(created_++);
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

void Points::remove_leaving() {
  close_gaps<double>(position_, dimension_, leaving_);
  close_gaps<double>(volume_, 1, leaving_);
  close_gaps<Index>(id_, 1, leaving_);
  close_gaps<Index>(body_, 1, leaving_);
  for (PointArray* array : attached_) {
    close_gaps<double>(array->values(), array->components(), leaving_);
  }
  resize(size() - static_cast<Index>(leaving_.size()));
  leaving_.clear();
  ++ordering_;
  moved();
}

std::vector<Index> Points::places_by_id() const {
  std::vector<Index> before(static_cast<std::size_t>(created_), 0);  // points of lower id
  for (const Index id : id_) {
    before[static_cast<std::size_t>(id)] = 1;
  }
  std::exclusive_scan(before.begin(), before.end(), before.begin(), Index{0});
  std::vector<Index> places;
  places.reserve(id_.size());
  for (const Index id : id_) {
    places.push_back(before[static_cast<std::size_t>(id)]);
  }
  return places;
}

std::vector<Index> Points::rows_by_id() const {
  const std::vector<Index> places = places_by_id();
  std::vector<Index> rows(places.size());
  for (std::size_t row = 0; row < places.size(); ++row) {
    rows[static_cast<std::size_t>(places[row])] = static_cast<Index>(row);
  }
  return rows;
}

void Points::resize(Index count) {
  const auto rows = static_cast<std::size_t>(count);
  position_.resize(rows * static_cast<std::size_t>(dimension_));
  volume_.resize(rows);
  id_.resize(rows);
  body_.resize(rows);
  for (PointArray* array : attached_) {
    array->values_.resize(rows * static_cast<std::size_t>(array->components()));
  }
}

void Points::save(Archive& archive) const {
  archive.write("points/position", position_);
  archive.write("points/volume", volume_);
  archive.write("points/id", id_);
  archive.write("points/body", body_);
}

void Points::load(const Archive& archive) {
  const auto count = static_cast<Index>(archive.read_indices("points/id").size());
  if (count > 0 && count <= created_) {
    resize(count);
  }
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
