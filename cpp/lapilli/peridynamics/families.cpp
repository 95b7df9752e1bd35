#include "lapilli/peridynamics/families.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/cell_list.hpp"
#include "lapilli/peridynamics/lanes.hpp"

namespace lapilli {
namespace {

/// Points searched as one piece.
constexpr Index search_rows = 512;

template <int Dim>
double squared_distance(const double* a, const double* b) {
  double squared = 0.0;
  for (int d = 0; d < Dim; ++d) {
    squared += (a[d] - b[d]) * (a[d] - b[d]);
  }
  return squared;
}

double squared_distance(int dimension, const double* a, const double* b) {
  switch (dimension) {
    case 1:
      return squared_distance<1>(a, b);
    case 2:
      return squared_distance<2>(a, b);
    default:
      return squared_distance<3>(a, b);
  }
}

}  // namespace

Families::Families(Points& points, double horizon, double skin, std::vector<FamilyRole> roles)
    : points_(points),
      horizon_(horizon),
      skin_(skin),
      roles_(std::move(roles)),
      reference_(points, points.dimension()) {
  require(points.size() < std::numeric_limits<std::int32_t>::max(),
          "families index points with 32 bits, got ", points.size(), " points");
}

bool Families::stale() {
  if (ordering_ != points_.ordering()) {
    return true;
  }
  if (version_ == points_.version()) {
    return false;
  }
  const double allowed = 0.5 * skin_;
  const Points::Travel now = points_.travel();
  const double bound = displacement_ + (now.path - seen_.path);
  if (now.leaps == seen_.leaps && bound < (1.0 - 1e-6) * allowed) {
    return false;
  }
  displacement_ = largest_displacement();
  seen_ = now;
  return !(displacement_ <= allowed);
}

double Families::largest_displacement() const {
  const auto position = points_.position();
  const int dimension = points_.dimension();
  const Index tasks = (points_.size() + piece_rows - 1) / piece_rows;
  std::vector<double> most(static_cast<std::size_t>(tasks), 0.0);
  parallel_ranges(points_.size(), [&](Index begin, Index end) {
    double largest = 0.0;
    for (Index row = begin; row < end; ++row) {
      const double squared = squared_distance(dimension, position.data() + row * dimension,
                                              reference_.data() + row * dimension);
      // Written so that a position that is no number counts as far.
      largest = squared <= largest ? largest : std::min(1e300, squared);
    }
    most[begin / piece_rows] = largest;
  });
  return std::sqrt(*std::max_element(most.begin(), most.end()));
}

bool Families::update() {
  const bool search_again = stale();
  if (search_again) {
    const auto position = points_.position();
    std::copy(position.begin(), position.end(), reference_.data());
    displacement_ = 0.0;
    seen_ = points_.travel();
    search();
  }
  version_ = points_.version();
  return search_again;
}

/// The families of some points that follow each other.
struct Families::Piece {
  std::vector<std::int32_t> neighbour;
  std::vector<Index> size, wall_begin, end;  // by point

  /// Add a point's: neighbours, those in walls last, filled up with itself to whole lanes.
  void add(Index row, std::span<const std::int32_t> others, std::span<const std::int32_t> wall) {
    const auto first = static_cast<Index>(neighbour.size());
    const auto count = [&] { return static_cast<Index>(neighbour.size()) - first; };
    neighbour.insert(neighbour.end(), others.begin(), others.end());
    wall_begin.push_back(count());
    neighbour.insert(neighbour.end(), wall.begin(), wall.end());
    end.push_back(count());
    while (count() % lanes::width != 0) {
      neighbour.push_back(static_cast<std::int32_t>(row));
    }
    size.push_back(count());
  }
};

void Families::search() {
  const int dimension = points_.dimension();
  const Index rows = points_.size();
  for (Index row = 0; row < rows * dimension; ++row) {
    if (!(std::abs(reference_[row]) < 1e150)) {
      throw RunError(message("position of point ", points_.id()[row / dimension],
                             " is no longer a number: the step is too long for this flow"));
    }
  }
  join(search_pieces());
  ordering_ = points_.ordering();
  ++searches_;
}

std::vector<Families::Piece> Families::search_pieces() const {
  const int dimension = points_.dimension();
  const Index rows = points_.size();
  const double radius = horizon_ + skin_;
  const CellList cells(reference_.values(), dimension, radius);
  const auto body = points_.body();
  enum class Kind : char { absent, wall, other };
  std::vector<Kind> kind(static_cast<std::size_t>(rows));
  parallel_for(rows, [&](Index row) {
    const FamilyRole role = roles_[body[row]];
    kind[row] = role.member == Member::absent ? Kind::absent : role.wall ? Kind::wall : Kind::other;
  });

  const Index tasks = (rows + search_rows - 1) / search_rows;
  std::vector<Piece> pieces(static_cast<std::size_t>(tasks));
  parallel_tasks(tasks, [&](Index task) {
    std::vector<std::int32_t> others, wall;
    for (Index row = task * search_rows; row < std::min(rows, (task + 1) * search_rows); ++row) {
      others.clear();
      wall.clear();
      if (roles_[body[row]].member == Member::owner) {
        Vec3 here = Vec3::Zero();
        std::copy_n(reference_.data() + row * dimension, dimension, here.data());
        cells.each_within(here, radius, [&](Index other, double) {
          if (other != row && kind[other] != Kind::absent) {
            (kind[other] == Kind::wall ? wall : others).push_back(static_cast<std::int32_t>(other));
          }
        });
      }
      pieces[task].add(row, others, wall);
    }
  });
  return pieces;
}

void Families::join(const std::vector<Piece>& pieces) {
  const Index rows = points_.size();
  begin_.assign(static_cast<std::size_t>(rows + 1), 0);
  wall_begin_.resize(static_cast<std::size_t>(rows));
  end_.resize(static_cast<std::size_t>(rows));
  largest_ = 0;
  for (Index row = 0; row < rows; ++row) {
    const Piece& piece = pieces[row / search_rows];
    const Index k = row % search_rows;
    wall_begin_[row] = begin_[row] + piece.wall_begin[k];
    end_[row] = begin_[row] + piece.end[k];
    begin_[row + 1] = begin_[row] + piece.size[k];
    largest_ = std::max(largest_, piece.size[k]);
  }
  neighbour_.resize(static_cast<std::size_t>(begin_[rows]));
  parallel_tasks(static_cast<Index>(pieces.size()), [&](Index task) {
    const auto& from = pieces[task].neighbour;
    std::copy(from.begin(), from.end(), neighbour_.begin() + begin_[task * search_rows]);
  });
}

std::vector<TaskRange> Families::reach(Index piece_size) const {
  const Index rows = points_.size(), tasks = (rows + piece_size - 1) / piece_size;
  std::vector<TaskRange> pieces(static_cast<std::size_t>(tasks));
  parallel_runs(tasks, [&](Index task) {
    const Index first = task * piece_size, end = std::min(rows, first + piece_size);
    auto least = static_cast<std::int32_t>(first), most = static_cast<std::int32_t>(end - 1);
    for (Index bond = begin_[first]; bond < begin_[end]; ++bond) {
      least = std::min(least, neighbour_[bond]);
      most = std::max(most, neighbour_[bond]);
    }
    pieces[task] = {least / piece_size, most / piece_size};
  });
  return pieces;
}

void Families::save(Archive& archive, const std::string& name) const {
  archive.write(name + "/reference", reference_.values());
  archive.write(name + "/searches", searches_);
  archive.write(name + "/ordered", static_cast<Index>(ordering_ == points_.ordering() ? 1 : 0));
}

void Families::load(const Archive& archive, const std::string& name) {
  archive.read(name + "/reference", reference_.values());
  search();
  searches_ = archive.read_index(name + "/searches");
  // A list that a re-ordering had made stale stays stale.
  ordering_ = archive.read_index(name + "/ordered") == 1 ? points_.ordering() : -1;
  seen_.leaps = -1;
  version_ = -1;
}

std::vector<Index> cell_order(const Points& points, double cell) {
  const CellList cells(points.position(), points.dimension(), cell);
  return {cells.order().begin(), cells.order().end()};
}

}  // namespace lapilli
