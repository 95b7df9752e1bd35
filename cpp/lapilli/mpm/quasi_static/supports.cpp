#include "lapilli/mpm/quasi_static/supports.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

/// Sets that are joined pair by pair.
class JoinedSets {
 public:
  explicit JoinedSets(Index count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index root(Index k) {
    while (parent_[k] != k) {
      parent_[k] = parent_[parent_[k]];
      k = parent_[k];
    }
    return k;
  }
  void join(Index a, Index b) { parent_[root(a)] = root(b); }

 private:
  std::vector<Index> parent_;
};

template <int Dim>
inline constexpr int rigid_motions = Dim == 2 ? 3 : 6;
template <int Dim>
using Motions = Eigen::Matrix<double, Dim, rigid_motions<Dim>>;

/// Displacements at `arm` (in units of the part's size, from its middle) of the translations along
/// the axes and the rotations about them.
template <int Dim>
Motions<Dim> motions_at(const Vec<Dim>& arm) {
  Motions<Dim> motions;
  motions.template leftCols<Dim>().setIdentity();
  if constexpr (Dim == 2) {
    motions.col(2) = Vec<2>(-arm[1], arm[0]);
  } else {
    for (int axis = 0; axis < 3; ++axis) {
      motions.col(3 + axis) = Vec<3>::Unit(axis).cross(arm);
    }
  }
  return motions;
}

template <int Dim>
Mat<Dim> held_directions(HeldMotion kind, const Vec<Dim>& normal) {
  const Mat<Dim> across = normal * normal.transpose();
  switch (kind) {
    case HeldMotion::roller:
      return across;
    case HeldMotion::tangent:
      return Mat<Dim>::Identity() - across;
    case HeldMotion::fixed:
      break;
  }
  return Mat<Dim>::Identity();
}

template <int Dim>
struct Part {
  double volume = 0.0;
  Vec<Dim> moment = Vec<Dim>::Zero();
  Vec<Dim> low = Vec<Dim>::Constant(1e300), high = Vec<Dim>::Constant(-1e300);
  Eigen::Matrix<double, rigid_motions<Dim>, rigid_motions<Dim>> held =
      Eigen::Matrix<double, rigid_motions<Dim>, rigid_motions<Dim>>::Zero();
  double area = 0.0;
  std::set<Index> bodies;

  Vec<Dim> middle() const { return moment / volume; }
  double size() const { return (high - low).norm(); }
};

/// "(0.2, 0.1)", to six digits.
template <int Dim>
std::string text(const Vec<Dim>& place) {
  std::ostringstream words;
  words << '(';
  for (int axis = 0; axis < Dim; ++axis) {
    words << (axis > 0 ? ", " : "") << (std::abs(place[axis]) < 1e-12 ? 0.0 : place[axis]);
  }
  words << ')';
  return words.str();
}

/// The motion of a null vector in words.
template <int Dim>
std::string in_words(const Part<Dim>& part, const Eigen::VectorXd& mode) {
  const Vec<Dim> shift = mode.head<Dim>();
  const Eigen::VectorXd spin = mode.tail(mode.size() - Dim);
  if (spin.norm() < 1e-6) {
    Index most = 0;
    shift.cwiseAbs().maxCoeff(&most);
    const double sense = shift[most] < 0.0 ? -1.0 : 1.0;  // of a mode it is any
    return message("translation along ", text<Dim>(sense * shift.normalized()));
  }
  if constexpr (Dim == 2) {
    const Vec<2> centre = part.middle() + part.size() * Vec<2>(-shift[1], shift[0]) / spin[0];
    return message("rotation about ", text<2>(centre), " m");
  } else {
    const Vec<3> axis = spin.head<3>();
    const Vec<3> through = part.middle() + part.size() * axis.cross(shift) / axis.squaredNorm();
    return message("rotation about the axis ", text<3>(axis.normalized()), " through ",
                   text<3>(through), " m");
  }
}

template <int Dim>
using Parts = std::map<Index, Part<Dim>>;  // by the root of their nodes

/// Points that share nodes, directly or through others.
template <int Dim>
Parts<Dim> parts_of(const Grid<Dim>& grid, const Points& points, const PointWeights<Dim>& weights,
                    JoinedSets& nodes) {
  for (const auto& group : weights.groups()) {
    const Index first = grid.node_index(group.box.first);
    for_each_node(grid, group.box, [&](int, Index node) { nodes.join(node, first); });
  }
  Parts<Dim> parts;
  for (const auto& group : weights.groups()) {
    Part<Dim>& part = parts[nodes.root(grid.node_index(group.box.first))];
    for (Index k = group.begin; k < group.end; ++k) {
      const Index p = weights.order()[k];
      const Vec<Dim> position = points.position<Dim>(p);
      part.bodies.insert(points.body()[p]);
      part.volume += points.volume()[p];
      part.moment += points.volume()[p] * position;
      part.low = part.low.cwiseMin(position);
      part.high = part.high.cwiseMax(position);
    }
  }
  for (auto& [root, part] : parts) {
    part.low -= Vec<Dim>::Constant(0.5 * grid.cell_size());
    part.high += Vec<Dim>::Constant(0.5 * grid.cell_size());
  }
  return parts;
}

/// Motions of a part that nothing stops, in words; empty where there is none.
template <int Dim>
std::string free_motions(const Part<Dim>& part) {
  if (part.area == 0.0) {
    return "every rigid motion";
  }
  constexpr double least = 1e-9;  // of the held area, squared motions
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(part.held / part.area);
  std::string free;
  for (int k = 0; k < rigid_motions<Dim>; ++k) {
    if (modes.eigenvalues()[k] < least) {
      free += (free.empty() ? "" : "; ") + in_words<Dim>(part, modes.eigenvectors().col(k));
    }
  }
  return free;
}

}  // namespace

template <int Dim>
void require_held(const Grid<Dim>& grid, const Points& points, const PointWeights<Dim>& weights,
                  std::span<const Facet<Dim>> facets, std::span<const HeldMotion> kinds) {
  JoinedSets nodes(grid.node_count());
  Parts<Dim> parts = parts_of(grid, points, weights, nodes);
  for (const Facet<Dim>& facet : facets) {
    // A facet in an empty cell holds the part whose nodes it shares.
    CellBox<Dim> box{facet.cell, {}};
    box.cells.fill(1);
    Part<Dim>* part = nullptr;
    for_each_node(grid, box, [&](int, Index node) {
      const auto found = parts.find(nodes.root(node));
      part = found != parts.end() ? &found->second : part;
    });
    if (part == nullptr) {
      continue;
    }
    for (const auto& point : facet.points) {
      const Motions<Dim> motions =
          motions_at<Dim>((point.position - part->middle()) / part->size());
      part->held += point.weight * motions.transpose() *
                    held_directions<Dim>(kinds[facet.surface], point.normal) * motions;
      part->area += point.weight;
    }
  }
  for (const auto& [root, part] : parts) {
    if (const std::string free = free_motions<Dim>(part); !free.empty()) {
      std::string bodies;
      for (const Index body : part.bodies) {
        bodies += message(bodies.empty() ? "" : " and ", body);
      }
      throw RunError(message("body ", bodies, ": the material around ", text<Dim>(part.middle()),
                             " m is held by nothing against ", free,
                             ": add a support that stops it, or remove this part"));
    }
  }
}

template <int Dim>
void require_agreeing(const Grid<Dim>& grid, std::span<const Facet<Dim>> facets,
                      const std::vector<std::vector<Vec<Dim>>>& motions,
                      std::span<const HeldMotion> kinds, std::span<const std::string> names) {
  std::map<Index, std::vector<std::size_t>> by_cell;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    by_cell[grid.cell_index(facets[f].cell)].push_back(f);
  }
  const double near = 1e-6 * grid.cell_size();
  const auto size = [](const Facet<Dim>& facet) { return std::pow(facet.area(), 1.0 / (Dim - 1)); };
  for (const auto& [cell, members] : by_cell) {
    for (std::size_t a : members) {
      for (std::size_t b : members) {
        const Facet<Dim>&one = facets[a], &other = facets[b];
        if (one.surface >= other.surface) {
          continue;
        }
        const Vec<Dim> normal = one.normal(), apart = other.centre() - one.centre();
        const bool same_place = std::abs(normal.dot(other.normal())) > 1.0 - 1e-6 &&
                                std::abs(normal.dot(apart)) < near &&
                                apart.norm() < 0.5 * (size(one) + size(other)) - near;
        if (!same_place) {
          continue;
        }
        const Mat<Dim> both = held_directions<Dim>(kinds[one.surface], normal) *
                              held_directions<Dim>(kinds[other.surface], normal);
        const Vec<Dim> difference = both * (motions[b].front() - motions[a].front());
        if (difference.norm() > 1e-9 * grid.cell_size()) {
          throw RunError(message("supports '", names[one.surface], "' and '", names[other.surface],
                                 "' contradict each other near ", text<Dim>(one.centre()),
                                 " m: on the same surface their displacements differ by ",
                                 difference.norm(), " m in this load step"));
        }
      }
    }
  }
}

template void require_held(const Grid<2>&, const Points&, const PointWeights<2>&,
                           std::span<const Facet<2>>, std::span<const HeldMotion>);
template void require_held(const Grid<3>&, const Points&, const PointWeights<3>&,
                           std::span<const Facet<3>>, std::span<const HeldMotion>);
template void require_agreeing(const Grid<2>&, std::span<const Facet<2>>,
                               const std::vector<std::vector<Vec<2>>>&, std::span<const HeldMotion>,
                               std::span<const std::string>);
template void require_agreeing(const Grid<3>&, std::span<const Facet<3>>,
                               const std::vector<std::vector<Vec<3>>>&, std::span<const HeldMotion>,
                               std::span<const std::string>);

}  // namespace lapilli
