#include "lapilli/peridynamics/families.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/peridynamics/lanes.hpp"

namespace lapilli {
namespace {

/// Points sorted into cells of at least the search radius; unused dimensions have one cell.
class CellList {
 public:
  CellList(int dimension, std::span<const double> position, double radius)
      : dimension_(dimension), rows_(static_cast<Index>(position.size()) / dimension) {
    lower_.fill(0.0);
    std::array<double, 3> upper{};
    for (int d = 0; d < dimension; ++d) {
      lower_[d] = std::numeric_limits<double>::infinity();
      upper[d] = -lower_[d];
      for (Index row = 0; row < rows_; ++row) {
        lower_[d] = std::min(lower_[d], position[row * dimension + d]);
        upper[d] = std::max(upper[d], position[row * dimension + d]);
      }
    }
    cell_ = radius;
    // Widely scattered points: larger cells rather than more of them than points.
    const double most = 8.0 * static_cast<double>(rows_) + 64.0;
    double cells = 0.0;
    do {
      cells = 1.0;
      for (int d = 0; d < dimension; ++d) {
        cells *= std::floor((upper[d] - lower_[d]) / cell_) + 1.0;
      }
      cell_ *= cells > most ? 2.0 : 1.0;
    } while (cells > most);
    count_.fill(1);
    for (int d = 0; d < dimension; ++d) {
      count_[d] = static_cast<Index>((upper[d] - lower_[d]) / cell_) + 1;
    }
    sort(position);
  }

  std::array<Index, 3> cell_of(const double* position) const {
    std::array<Index, 3> cell{};
    for (int d = 0; d < dimension_; ++d) {
      cell[d] = std::clamp<Index>(static_cast<Index>((position[d] - lower_[d]) / cell_), 0,
                                  count_[d] - 1);
    }
    return cell;
  }

  /// Call body(row) for all points in the cells around `cell`, in a fixed order.
  template <class Body>
  void around(const std::array<Index, 3>& cell, const Body& body) const {
    for (Index z = std::max<Index>(0, cell[2] - 1); z <= std::min(count_[2] - 1, cell[2] + 1);
         ++z) {
      for (Index y = std::max<Index>(0, cell[1] - 1); y <= std::min(count_[1] - 1, cell[1] + 1);
           ++y) {
        const Index line = (z * count_[1] + y) * count_[0];
        const Index first = line + std::max<Index>(0, cell[0] - 1);
        const Index last = line + std::min(count_[0] - 1, cell[0] + 1);
        for (Index k = head_[first]; k < head_[last + 1]; ++k) {
          body(order_[k]);
        }
      }
    }
  }

  const std::vector<Index>& order() const { return order_; }

 private:
  void sort(std::span<const double> position) {
    std::vector<Index> cell(static_cast<std::size_t>(rows_));
    head_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2] + 1), 0);
    for (Index row = 0; row < rows_; ++row) {
      const auto c = cell_of(position.data() + row * dimension_);
      cell[row] = (c[2] * count_[1] + c[1]) * count_[0] + c[0];
      ++head_[cell[row] + 1];
    }
    for (std::size_t c = 1; c < head_.size(); ++c) {
      head_[c] += head_[c - 1];
    }
    std::vector<Index> next(head_.begin(), head_.end() - 1);
    order_.resize(static_cast<std::size_t>(rows_));
    for (Index row = 0; row < rows_; ++row) {
      order_[next[cell[row]]++] = row;
    }
  }

  int dimension_;
  Index rows_;
  double cell_ = 0.0;
  std::array<double, 3> lower_{};
  std::array<Index, 3> count_{};
  std::vector<Index> head_, order_;
};

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

bool Families::stale() const {
  if (ordering_ != points_.ordering()) {
    return true;
  }
  if (version_ == points_.version()) {
    return false;
  }
  const auto position = points_.position();
  const int dimension = points_.dimension();
  const double allowed = 0.25 * skin_ * skin_;
  const Index tasks = (points_.size() + piece_rows - 1) / piece_rows;
  std::vector<char> far(static_cast<std::size_t>(tasks), 0);
  parallel_ranges(points_.size(), [&](Index begin, Index end) {
    bool any = false;
    for (Index row = begin; row < end; ++row) {
      const double* reference = reference_.data() + row * dimension;
      // Written so that a position that is no number counts as far.
      any |=
          !(squared_distance(dimension, position.data() + row * dimension, reference) <= allowed);
    }
    far[begin / piece_rows] = any ? 1 : 0;
  });
  return std::any_of(far.begin(), far.end(), [](char any) { return any != 0; });
}

bool Families::update() {
  const bool search_again = stale();
  if (search_again) {
    const auto position = points_.position();
    std::copy(position.begin(), position.end(), reference_.data());
    search();
  }
  version_ = points_.version();
  return search_again;
}

void Families::search() {
  const int dimension = points_.dimension();
  const Index rows = points_.size();
  const double radius = horizon_ + skin_;
  for (Index row = 0; row < rows * dimension; ++row) {
    if (!(std::abs(reference_[row]) < 1e150)) {
      throw RunError(message("position of point ", points_.id()[row / dimension],
                             " is no longer a number: the step is too long for this flow"));
    }
  }
  const CellList cells(dimension, reference_.values(), radius);
  const auto body = points_.body();

  struct Piece {
    std::vector<std::int32_t> neighbour, wall;
    std::vector<Index> size, wall_begin, end;
  };
  const Index tasks = (rows + search_rows - 1) / search_rows;
  std::vector<Piece> pieces(static_cast<std::size_t>(tasks));
  parallel_tasks(tasks, [&](Index task) {
    Piece& piece = pieces[task];
    for (Index row = task * search_rows; row < std::min(rows, (task + 1) * search_rows); ++row) {
      const auto first = static_cast<Index>(piece.neighbour.size());
      piece.wall.clear();
      if (roles_[body[row]].member == Member::owner) {
        const double* here = reference_.data() + row * dimension;
        cells.around(cells.cell_of(here), [&](Index other) {
          const FamilyRole role = roles_[body[other]];
          if (other == row || role.member == Member::absent ||
              squared_distance(dimension, here, reference_.data() + other * dimension) >=
                  radius * radius) {
            return;
          }
          (role.wall ? piece.wall : piece.neighbour).push_back(static_cast<std::int32_t>(other));
        });
      }
      piece.wall_begin.push_back(static_cast<Index>(piece.neighbour.size()) - first);
      piece.neighbour.insert(piece.neighbour.end(), piece.wall.begin(), piece.wall.end());
      piece.end.push_back(static_cast<Index>(piece.neighbour.size()) - first);
      while ((static_cast<Index>(piece.neighbour.size()) - first) % lanes::width != 0) {
        piece.neighbour.push_back(static_cast<std::int32_t>(row));
      }
      piece.size.push_back(static_cast<Index>(piece.neighbour.size()) - first);
    }
  });

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
  parallel_tasks(tasks, [&](Index task) {
    const auto& from = pieces[task].neighbour;
    std::copy(from.begin(), from.end(), neighbour_.begin() + begin_[task * search_rows]);
  });
  ordering_ = points_.ordering();
  ++searches_;
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
  version_ = -1;
}

std::vector<Index> cell_order(const Points& points, double cell) {
  return CellList(points.dimension(), points.position(), cell).order();
}

}  // namespace lapilli
