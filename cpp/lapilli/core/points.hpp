#pragma once

#include <Eigen/LU>
#include <span>
#include <utility>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/large_array.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/vector.hpp"

namespace lapilli {

class PointArray;

/// The points of a simulation: position, volume, id, body. Every array that belongs to points is
/// attached here and follows when they are re-ordered or leave. One physics at most moves them.
class Points {
 public:
  explicit Points(int dimension);
  Points(const Points&) = delete;
  Points& operator=(const Points&) = delete;

  /// Append points before the simulation starts; `positions` is rows x dimension. Ids count on.
  void append(std::span<const double> positions, std::span<const double> volumes, int body);

  int dimension() const { return dimension_; }
  Index size() const { return static_cast<Index>(id_.size()); }
  /// Points that there were at the start.
  Index created() const { return created_; }

  std::span<double> position() { return position_; }              // m, size x dimension
  std::span<const double> position() const { return position_; }  //
  std::span<double> volume() { return volume_; }                  // current volume, m^dim
  std::span<const double> volume() const { return volume_; }      //
  std::span<const Index> id() const { return id_; }               // 0, 1, ..; never changes
  std::span<const Index> body() const { return body_; }           // which body of the scene

  template <int Dim>
  Vec<Dim> position(Index point) const {
    return Eigen::Map<const Vec<Dim>>(position_.data() + point * Dim);
  }

  /// Say that positions (or volumes) have changed. Weights built before are stale.
  void moved() {
    ++version_;
    ++travel_.leaps;
  }
  /// The same, when no point moved further than `distance` (m).
  void moved_at_most(double distance) {
    ++version_;
    travel_.path += distance;
  }
  /// The same, when the neighbourhood of row k was deformed by F = increment(k): carried gradients
  /// follow, G <- F^-T G.
  template <int Dim, class Increment>
  void moved(const Increment& increment);
  Index version() const { return version_; }
  /// How far points have come: while `leaps` stays the same, none has moved further than `path` (m)
  /// has grown.
  struct Travel {
    Index leaps = 0;
    double path = 0.0;
  };
  const Travel& travel() const { return travel_; }
  /// Whether an attached array holds gradients, so that whoever moves the points must say how they
  /// were deformed.
  bool carry_gradients() const;

  /// Re-order: new row k holds what was in row order[k]; attached arrays follow in place, so their
  /// addresses stay.
  void permute(std::span<const Index> order);
  /// Say, during a step, which rows leave the simulation at its end; in rising order.
  void leave(std::vector<Index> rows) { leaving_ = std::move(rows); }
  std::span<const Index> leaving() const { return leaving_; }
  /// Take the rows that leave out of all arrays; the others keep their order.
  void remove_leaving();
  /// The rows in order of id, and the place of every row in that order.
  std::vector<Index> rows_by_id() const;
  std::vector<Index> places_by_id() const;
  /// Counts re-orderings, for those who keep row numbers.
  Index ordering() const { return ordering_; }

  void save(Archive& archive) const;
  /// Read what was saved, of as many points as there were then.
  void load(const Archive& archive);

 private:
  friend class PointArray;
  void resize(Index count);
  void attach(PointArray* array);
  void detach(PointArray* array);

  int dimension_;
  LargeArray<double> position_, volume_;
  std::vector<Index> id_, body_;
  std::vector<PointArray*> attached_;
  std::vector<Index> leaving_;
  Index created_ = 0;
  Index version_ = 0, ordering_ = 0;
  Travel travel_;
};

/// A per-point array of `components` doubles a row, owned by a physics, that follows the points.
/// The points must outlive it, and be complete when it is made.
class PointArray {
 public:
  /// Whether rows are plain numbers or spatial gradients (`dimension` components) that turn and
  /// stretch with the material.
  enum class Kind { plain, gradient };

  PointArray(Points& points, int components, double value = 0.0, Kind kind = Kind::plain);
  ~PointArray();
  PointArray(const PointArray&) = delete;
  PointArray& operator=(const PointArray&) = delete;

  int components() const { return components_; }
  Kind kind() const { return kind_; }
  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }
  std::span<double> values() { return values_; }
  std::span<const double> values() const { return values_; }
  double& operator[](Index row) { return values_[static_cast<std::size_t>(row)]; }
  double operator[](Index row) const { return values_[static_cast<std::size_t>(row)]; }

 private:
  friend class Points;
  Points& points_;
  int components_;
  Kind kind_;
  LargeArray<double> values_;
};

template <int Dim, class Increment>
void Points::moved(const Increment& increment) {
  for (PointArray* array : attached_) {
    if (array->kind() == PointArray::Kind::gradient) {
      parallel_for(size(), [&](Index row) {
        Eigen::Map<Vec<Dim>> gradient(array->data() + row * Dim);
        const Mat<Dim> deformation = increment(row);
        gradient = Vec<Dim>(deformation.inverse().transpose() * gradient);
      });
    }
  }
  moved();
}

}  // namespace lapilli
