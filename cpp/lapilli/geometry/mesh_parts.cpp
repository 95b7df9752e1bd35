#include "lapilli/geometry/mesh_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

using Face = std::vector<Vec3>;
using Corners = std::array<Vec3, 3>;

// A box is empty or whole to within this share of it.
constexpr double rounding = 1e-12;

// What is left of a face where sign * x[axis] <= sign * at.
void keep_below(Face& face, int axis, double at, double sign, Face& kept) {
  kept.clear();
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3 &here = face[k], &next = face[(k + 1) % face.size()];
    const double a = sign * (here[axis] - at), b = sign * (next[axis] - at);
    if (a <= 0.0) {
      kept.push_back(here);
    }
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) {
      kept.push_back(a < 0.0 ? Vec3(here + a / (a - b) * (next - here))
                             : Vec3(next + b / (b - a) * (here - next)));
      kept.back()[axis] = at;
    }
  }
  std::swap(face, kept);
}

double twice_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Calls add(x, area) for places and areas, seen from above, that integrate polynomials of degree 4
// over a face (Strang and Fix 1973); faces that face down count negative.
template <class Add>
void each_place(const Face& face, const Add& add) {
  static constexpr double far[] = {0.8168475729804585, 0.1081030181680702};
  static constexpr double near[] = {0.0915762135097707, 0.4459484909159649};
  static constexpr double weight[] = {0.1099517436553219, 0.2233815896780115};
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    const Corners corner{face[0], face[k], face[k + 1]};
    const double area = 0.5 * twice_area(corner[0], corner[1], corner[2]);
    const Vec3 sum = corner[0] + corner[1] + corner[2];
    for (std::size_t ring = 0; ring < 2; ++ring) {
      for (const Vec3& one : corner) {
        add(Vec3(near[ring] * sum + (far[ring] - near[ring]) * one), weight[ring] * area);
      }
    }
  }
}

// A rod of the cross-section `area` from height 0 to x[2].
void add_rod(MomentSum& sum, const Vec3& x, double area) {
  const double h = x[2], volume = area * h;
  const Vec3 middle(x[0], x[1], 0.5 * h);
  sum.volume += volume;
  sum.first += volume * middle;
  sum.second += volume * middle * middle.transpose();
  sum.second(2, 2) += volume * h * h / 12.0;
}

// The boxes above one square of the lattice.
class Column {
 public:
  Column(const Sites& sites, Index x, Index y)
      : sites_(sites), side_(sites.spacing()), base_(sites.corner({x, y, sites.first()[2]})) {
    const auto count = static_cast<std::size_t>(sites.last()[2] - sites.first()[2] + 1);
    in_box_.resize(count);
    below_.resize(count);
  }

  // `facing` is -1 for surfaces whose triangles face in.
  void add(const Corners& triangle, double facing) {
    face_.assign({triangle[0] - base_, triangle[1] - base_, triangle[2] - base_});
    for (int axis = 0; axis < 2; ++axis) {
      keep_below(face_, axis, 0.0, -1.0, spare_);
      keep_below(face_, axis, side_, 1.0, spare_);
    }
    if (face_.size() < 3) {
      return;
    }
    double low = face_[0][2], high = low;
    for (const Vec3& corner : face_) {
      low = std::min(low, corner[2]);
      high = std::max(high, corner[2]);
    }
    const auto last = static_cast<Index>(in_box_.size()) - 1;
    const Index from = std::clamp(static_cast<Index>(std::floor(low / side_)), Index{0}, last);
    const Index to = std::clamp(static_cast<Index>(std::floor(high / side_)), Index{0}, last);
    for (Index level = from; level <= to; ++level) {
      slice_ = face_;
      if (level > from) {
        keep_below(slice_, 2, static_cast<double>(level) * side_, -1.0, spare_);
      }
      if (level < to) {
        keep_below(slice_, 2, static_cast<double>(level + 1) * side_, 1.0, spare_);
      }
      add_slice(static_cast<std::size_t>(level), facing);
    }
  }

  void append(Index x, Index y, std::vector<BoxPart>& parts) const {
    const MomentSum full = moments_of_box(side_, 3);
    MomentSum through;
    for (std::size_t level = in_box_.size(); level-- > 0;) {
      const Sites::Site site{x, y, sites_.first()[2] + static_cast<Index>(level)};
      MomentSum sum = in_box_[level];
      sum.add(1.0, through);
      through.add(1.0, below_[level]);
      const bool is_whole = sum.volume >= (1.0 - rounding) * full.volume;
      Part part = (is_whole ? full : sum).part(sites_.corner(site), rounding * full.volume);
      part.is_whole = is_whole;
      if (part.volume > 0.0) {
        parts.push_back({site, part});
      }
    }
  }

 private:
  void add_slice(std::size_t level, double facing) {
    const double floor = static_cast<double>(level) * side_;
    each_place(slice_, [&](const Vec3& at, double area) {
      add_rod(in_box_[level], {at[0], at[1], at[2] - floor}, facing * area);
      add_rod(below_[level], {at[0], at[1], side_}, facing * area);
    });
  }

  const Sites& sites_;
  double side_;
  Vec3 base_;
  std::vector<MomentSum> in_box_;  // between the triangles in a box and its floor
  std::vector<MomentSum> below_;   // and what these add to every box below
  Face face_, slice_, spare_;
};

// The triangles over each square of the lattice, as rows of one list.
class OverSquares {
 public:
  OverSquares(const std::vector<Corners>& triangles, const Sites& sites)
      : wide_(sites.last()[0] - sites.first()[0] + 1),
        deep_(sites.last()[1] - sites.first()[1] + 1) {
    begin_.assign(static_cast<std::size_t>(wide_ * deep_) + 1, 0);
    each_square(triangles, sites, [&](std::size_t square, std::size_t) { ++begin_[square + 1]; });
    for (std::size_t k = 1; k < begin_.size(); ++k) {
      begin_[k] += begin_[k - 1];
    }
    triangle_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    each_square(triangles, sites, [&](std::size_t square, std::size_t triangle) {
      triangle_[next[square]++] = triangle;
    });
  }

  Index wide() const { return wide_; }
  Index deep() const { return deep_; }
  std::span<const std::size_t> at(Index column, Index row) const {
    const auto square = static_cast<std::size_t>(row * wide_ + column);
    return std::span(triangle_).subspan(begin_[square], begin_[square + 1] - begin_[square]);
  }

 private:
  template <class Visit>
  void each_square(const std::vector<Corners>& triangles, const Sites& sites,
                   const Visit& visit) const {
    const Vec3 base = sites.corner(sites.first());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto& [a, b, c] = triangles[k];
      const Vec3 low = (a.cwiseMin(b).cwiseMin(c) - base) / sites.spacing();
      const Vec3 high = (a.cwiseMax(b).cwiseMax(c) - base) / sites.spacing();
      const auto cell = [](double at, Index count) {
        return std::clamp(static_cast<Index>(std::floor(at)), Index{0}, count - 1);
      };
      for (Index row = cell(low[1], deep_); row <= cell(high[1], deep_); ++row) {
        for (Index column = cell(low[0], wide_); column <= cell(high[0], wide_); ++column) {
          visit(static_cast<std::size_t>(row * wide_ + column), k);
        }
      }
    }
  }

  Index wide_, deep_;
  std::vector<std::size_t> begin_, triangle_;
};

std::vector<Corners> corners_of(const TriangleSurface& surface, const Mat3& turn, const Vec3& shift,
                                const Sites& sites) {
  const Triangles& triangles = surface.triangles();
  std::vector<Corners> all;
  all.reserve(triangles.rows.size());
  const auto there = [&](int vertex) {
    const Vec3& x = triangles.vertices[static_cast<std::size_t>(vertex)];
    return sites.to_lattice(turn * x + shift);
  };
  for (const auto& row : triangles.rows) {
    all.push_back({there(row[0]), there(row[1]), there(row[2])});
  }
  return all;
}

}  // namespace

std::vector<BoxPart> mesh_parts(const TriangleSurface& surface, const Mat3& turn, const Vec3& shift,
                                const Sites& sites) {
  const std::vector<Corners> triangles = corners_of(surface, turn, shift, sites);
  const OverSquares over(triangles, sites);
  std::vector<std::vector<BoxPart>> rows(static_cast<std::size_t>(over.deep()));
  parallel_tasks(over.deep(), [&](Index row) {
    for (Index column = 0; column < over.wide(); ++column) {
      const auto found = over.at(column, row);
      if (!found.empty()) {
        const Index x = sites.first()[0] + column, y = sites.first()[1] + row;
        Column boxes(sites, x, y);
        for (const std::size_t triangle : found) {
          boxes.add(triangles[triangle], surface.sense());
        }
        boxes.append(x, y, rows[static_cast<std::size_t>(row)]);
      }
    }
  });
  std::vector<BoxPart> parts;
  for (std::vector<BoxPart>& row : rows) {
    parts.insert(parts.end(), row.begin(), row.end());
    row = {};
  }
  std::sort(parts.begin(), parts.end(),
            [](const BoxPart& a, const BoxPart& b) { return visited_before(a.site, b.site); });
  return parts;
}

}  // namespace lapilli
