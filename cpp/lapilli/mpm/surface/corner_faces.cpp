#include "lapilli/mpm/surface/corner_faces.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace lapilli {
namespace {

constexpr double radius = 2.5;       // cells
constexpr double same_face = 0.82;   // cosine of 35 degrees
constexpr double least_face = 0.1;   // of the largest area vector
constexpr double least_apart = 0.3;  // sine of the angle to the faces before

/// Area vectors around surface node k that point to its side, by the trust in each.
template <int Dim>
std::vector<Vec<Dim>> trusted_vectors(const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
                                      std::size_t k) {
  constexpr int reach = static_cast<int>(radius), width = 2 * reach + 1;
  std::vector<Vec<Dim>> found;
  const auto at = grid.node_at(areas.node[k]);
  for (int b = 0; b < (Dim == 2 ? width * width : width * width * width); ++b) {
    auto node = at;
    int square = 0;
    bool inside = true;
    for (int axis = 0, rest = b; axis < Dim; ++axis, rest /= width) {
      const int step = rest % width - reach;
      square += step * step;
      node[axis] += step;
      inside = inside && node[axis] >= 0 && node[axis] < grid.nodes(axis);
    }
    if (!inside || square > radius * radius) {
      continue;
    }
    const Index number = grid.node_index(node);
    const auto place = std::lower_bound(areas.node.begin(), areas.node.end(), number);
    if (place != areas.node.end() && *place == number) {
      const auto row = static_cast<std::size_t>(place - areas.node.begin());
      if (areas.vector[row].dot(areas.normal[k]) > 0.0) {
        found.push_back(areas.trust[row] * areas.vector[row]);
      }
    }
  }
  return found;
}

/// dual(f) . normal(g) is one where f is g, zero elsewhere.
template <int Dim>
void find_duals(std::vector<CornerFace<Dim>>& faces) {
  Eigen::Matrix<double, Dim, Eigen::Dynamic, 0, Dim, Dim> normals(Dim, faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    normals.col(f) = faces[f].normal;
  }
  const auto gram = (normals.transpose() * normals).eval();
  const auto duals = (normals * gram.inverse()).eval();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    faces[f].dual = duals.col(f);
  }
}

}  // namespace

template <int Dim>
std::vector<CornerFace<Dim>> faces_of_corner(const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
                                             std::size_t k) {
  std::vector<Vec<Dim>> found = trusted_vectors(grid, areas, k);
  // The largest vector starts a face and gathers those that point its way; then the largest left,
  // unless it lies among the faces before, as on a rounded edge.
  std::vector<CornerFace<Dim>> faces;
  Mat<Dim> apart = Mat<Dim>::Identity();  // projects across the faces so far
  double least = 0.0;
  for (const Vec<Dim>& a : found) {
    least = std::max(least, least_face * a.norm());
  }
  while (static_cast<int>(faces.size()) < Dim && !found.empty()) {
    const Vec<Dim> first = *std::ranges::max_element(found, {}, &Vec<Dim>::norm);
    if (first.norm() <= least) {
      break;
    }
    Vec<Dim> sum = Vec<Dim>::Zero();
    std::erase_if(found, [&](const Vec<Dim>& a) {
      const bool alike = a.dot(first) > same_face * a.norm() * first.norm();
      sum += alike ? a : Vec<Dim>(Vec<Dim>::Zero());
      return alike;
    });
    const Vec<Dim> normal = sum.normalized(), rest = apart * normal;
    if (rest.norm() > least_apart) {
      faces.push_back({normal, Vec<Dim>::Zero()});
      apart -= rest * rest.transpose() / rest.squaredNorm();
    }
  }
  if (faces.size() < 2) {
    return {};
  }
  find_duals(faces);
  return faces;
}

template std::vector<CornerFace<2>> faces_of_corner(const Grid<2>&, const NodalAreas<2>&,
                                                    std::size_t);
template std::vector<CornerFace<3>> faces_of_corner(const Grid<3>&, const NodalAreas<3>&,
                                                    std::size_t);
template <>
std::vector<CornerFace<1>> faces_of_corner(const Grid<1>&, const NodalAreas<1>&, std::size_t) {
  return {};  // a line has no corners
}

}  // namespace lapilli
