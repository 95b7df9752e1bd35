#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/points.hpp"

namespace lapilli {

/// What a point is to the families of one field, by the body it belongs to.
enum class Member : std::uint8_t {
  absent,     // in no family
  neighbour,  // in the families of others, has none itself
  owner       // has a family
};

/// Part of a body in one set of families.
struct FamilyRole {
  Member member = Member::owner;
  bool wall = false;  // listed behind the others, so that wall bonds are one range of their own
};

/// The families of a field: for each point all others within horizon + skin, in a compressed list.
///
/// The list serves until some point has moved half the skin since it was built. It depends on the
/// reference positions (those of the last search) and the order of points alone; both are saved, so
/// that a resumed run adds in the same order. Each family is padded with its owner to whole lanes:
/// such a bond has no length and must weigh nothing.
class Families {
 public:
  /// `roles` holds one entry a body. Lengths in m.
  Families(Points& points, double horizon, double skin, std::vector<FamilyRole> roles);

  /// Search again if points have moved too far or were re-ordered; true if it did.
  bool update();
  /// Whether `update` would search again.
  bool stale();

  Index begin(Index point) const { return begin_[point]; }
  /// The first bond to a wall; those before are bonds to points that are no wall, or padding.
  Index wall_begin(Index point) const { return wall_begin_[point]; }
  /// Behind the last true bond.
  Index end(Index point) const { return end_[point]; }
  /// Behind the padding: begin of the next family.
  Index padded_end(Index point) const { return begin_[point + 1]; }
  /// For each piece of `piece_size` points the pieces in which they and their families lie.
  std::vector<TaskRange> reach(Index piece_size) const;
  Index bonds() const { return static_cast<Index>(neighbour_.size()); }
  const std::int32_t* neighbours() const { return neighbour_.data(); }
  std::int32_t neighbour(Index bond) const { return neighbour_[bond]; }
  bool owns(Index point) const { return roles_[points_.body()[point]].member == Member::owner; }
  bool is_wall(Index point) const { return roles_[points_.body()[point]].wall; }

  double horizon() const { return horizon_; }
  Index searches() const { return searches_; }
  Index largest_family() const { return largest_; }

  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  struct Piece;
  void search();
  std::vector<Piece> search_pieces() const;
  void join(const std::vector<Piece>& pieces);
  double largest_displacement() const;

  Points& points_;
  double horizon_, skin_;
  std::vector<FamilyRole> roles_;
  PointArray reference_;
  std::vector<Index> begin_, wall_begin_, end_;
  LargeArray<std::int32_t> neighbour_;
  Index ordering_ = -1, version_ = -1, searches_ = 0, largest_ = 0;
  double displacement_ = 0.0;  // m, largest since the last search, when points had come to:
  Points::Travel seen_{-1, 0.0};
};

/// An order of the points by cells of `cell` m, row by row, stable within a cell.
std::vector<Index> cell_order(const Points& points, double cell);

}  // namespace lapilli
