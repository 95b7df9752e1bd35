#include "lapilli/mpm/heat/heat_part.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <numeric>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"
#include "lapilli/mpm/heat/cell_operators.hpp"
#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/heat/start_in_shape.hpp"

namespace lapilli {
namespace {

constexpr double hold_factor = 1e4;  // of a prescribed temperature, in conductivity / cell

/// Makes one part.
template <int Dim, class Function>
class Assembly {
 public:
  Assembly(const Points& points, const HeatProblem<Dim>& problem,
           const std::vector<CutBody<Dim>>& cut, std::vector<std::size_t> bodies,
           const Function& function)
      : points_(points),
        problem_(problem),
        grid_(problem.grid),
        layout_(problem.shape),
        cut_(cut),
        function_(function),
        active_(static_cast<std::size_t>(grid_.node_count()), 0) {
    part_.bodies = std::move(bodies);
  }

  HeatPart<Dim> make(std::vector<SurfaceFound>& found) {
    find_volumes(found);
    find_active();
    part_.rows = std::make_unique<NodeRows<Dim>>(grid_, active_, Function::support - 1);
    part_.conduction = std::make_unique<StencilMatrix<Dim>>(*part_.rows);
    for (const std::size_t body : part_.bodies) {
      add_conduction(body);
    }
    std::vector<double> all(active_.size(), 0.0);
    for (const auto& volume : volume_) {
      for (std::size_t node = 0; node < all.size(); ++node) {
        all[node] += volume[node];
      }
    }
    part_.followers = Followers<Dim>(grid_, *part_.rows, all, active_);
    store_heat();
    if (!leaders_keep_capacity(all)) {
      part_.followers = Followers<Dim>(grid_, *part_.rows, all, active_, false);
      part_.sources.clear();
      store_heat();
    }
    connect_surface();
    found[part_.bodies.front()].followers = static_cast<Index>(part_.followers.count());
    found[part_.bodies.front()].nodes = std::count(active_.begin(), active_.end(), 1);
    return std::move(part_);
  }

 private:
  using Cell = CellOperators<Dim, Function>;

  Cell cell_of(std::size_t body) const {
    const Mat<Dim> k = problem_.bodies[body].material.conductivity.template block<Dim>();
    return Cell(grid_, layout_, function_, k);
  }

  Index node_at(const typename Grid<Dim>::Cell& first, int local) const {
    auto at = first;
    const auto step = Cell::steps(local);
    for (int axis = 0; axis < Dim; ++axis) {
      at[axis] += step[axis];
    }
    return grid_.node_index(at);
  }

  void find_volumes(std::vector<SurfaceFound>& found) {
    for (const std::size_t body : part_.bodies) {
      Cell cell = cell_of(body);
      std::vector<double>& volume = volume_.emplace_back(active_.size(), 0.0);
      for (const CellCut<Dim>& cut : cut_[body].cells) {
        cell.integrate(cut);
        const auto first = cell.first_node(cut.node);
        for (int local = 0; local < Cell::nodes; ++local) {
          volume[node_at(first, local)] += cell.volumes[local];
        }
      }
      found[body].volume = std::accumulate(volume.begin(), volume.end(), 0.0);
    }
  }

  template <class Body>
  void for_each_node(const Vec<Dim>& at, const Body& body) const {
    Weights<Dim, Function>(grid_, function_, at.data())
        .for_each_node(grid_, [&](Index node, double s, const Vec<Dim>&) {
          if (s > 0.0) {
            body(node, s);
          }
        });
  }

  void find_active() {
    for (const auto& volume : volume_) {
      for (std::size_t node = 0; node < active_.size(); ++node) {
        active_[node] = active_[node] != 0 || volume[node] > 0.0;
      }
    }
    const auto activate = [&](Index node, double) { active_[node] = 1; };
    for (const std::size_t body : part_.bodies) {
      for (const auto& pieces : cut_[body].pieces) {
        for (const SurfacePiece<Dim>& piece : pieces) {
          for (const auto& site : piece.quadrature()) {
            for_each_node(site.position, activate);
          }
        }
      }
    }
    for (Index row = 0; row < points_.size(); ++row) {
      const auto body = static_cast<std::size_t>(points_.body()[row]);
      if (std::find(part_.bodies.begin(), part_.bodies.end(), body) != part_.bodies.end()) {
        for_each_node(points_.position<Dim>(row), activate);
      }
    }
  }

  void add_conduction(std::size_t body) {
    Cell cell = cell_of(body);
    for (const CellCut<Dim>& cut : cut_[body].cells) {
      cell.integrate(cut);
      const auto first = cell.first_node(cut.node);
      std::array<Index, Cell::nodes> place;
      for (int local = 0; local < Cell::nodes; ++local) {
        const Index node = node_at(first, local);
        place[local] = active_[node] != 0 ? part_.rows->place(node) : -1;
      }
      for (int a = 0; a < Cell::nodes; ++a) {
        const auto from = Cell::steps(a);
        for (int b = a; b < Cell::nodes && place[a] >= 0; ++b) {
          if (place[b] < 0 || cell.conduction(a, b) == 0.0) {
            continue;
          }
          auto step = Cell::steps(b);
          for (int axis = 0; axis < Dim; ++axis) {
            step[axis] -= from[axis];
          }
          part_.conduction->add(place[a], step, cell.conduction(a, b));
        }
      }
    }
  }

  void store_heat() {
    const auto size = static_cast<std::size_t>(part_.rows->size());
    part_.capacity.assign(size, 0.0);
    part_.temperature.assign(size, 0.0);
    for (std::size_t k = 0; k < part_.bodies.size(); ++k) {
      const std::size_t number = part_.bodies[k];
      const HeatBody& body = problem_.bodies[number];
      const double capacity = body.material.capacity();
      typename HeatPart<Dim>::BodyVolume own{number, {}, {}, {}};
      std::vector<Index> nodes;
      for (Index node = 0; node < grid_.node_count(); ++node) {
        if (volume_[k][node] > 0.0) {
          nodes.push_back(node);
          own.place.push_back(part_.rows->place(node));
          own.volume.push_back(volume_[k][node]);
        }
      }
      own.position = places_in_shape<Dim>(*body.shape, grid_, nodes);
      const std::vector<double> start =
          start_at_nodes<Dim>(body.temperature, *body.shape, grid_, nodes, number);
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        part_.capacity[own.place[j]] += capacity * own.volume[j];
        part_.temperature[own.place[j]] += capacity * own.volume[j] * start[j];
      }
      if (!body.source.is_constant() || body.source.at(0.0) != 0.0) {
        part_.sources.push_back(std::move(own));
      }
    }
    bool uniform = true;
    const Value& first = problem_.bodies[part_.bodies.front()].temperature;
    for (const std::size_t body : part_.bodies) {
      const Value& one = problem_.bodies[body].temperature;
      uniform = uniform && !one.is_function() && one.at(0.0) == first.at(0.0);
    }
    for (std::size_t place = 0; place < size; ++place) {
      if (part_.capacity[place] > 0.0) {
        double& value = part_.temperature[place];
        value = uniform ? first.at(0.0) : value / part_.capacity[place];
      }
    }
    part_.followers.restrict_to_leaders(part_.capacity);
    part_.followers.prolong(part_.temperature);
  }

  /// Whether all nodes that lead have a fifth of their own capacity and more with their followers.
  bool leaders_keep_capacity(const std::vector<double>& volume) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t body : part_.bodies) {
      least = std::min(least, problem_.bodies[body].material.capacity());
    }
    for (Index node = 0; node < grid_.node_count(); ++node) {
      if (active_[node] == 0 || volume[node] <= 0.0) {
        continue;
      }
      const Index place = part_.rows->place(node);
      if (!part_.followers.follows(place) && part_.capacity[place] < 0.2 * least * volume[node]) {
        return false;
      }
    }
    return true;
  }

  void connect_surface() {
    std::vector<Index> unknown(static_cast<std::size_t>(part_.rows->size()), -1);
    const std::size_t laws = problem_.settings.boundaries.size();
    std::vector<std::vector<Eigen::Triplet<double>>> entries(laws);
    part_.surface.resize(laws);
    const auto number_of = [&](Index place) {
      if (unknown[place] < 0) {
        unknown[place] = static_cast<Index>(part_.unknown_place.size());
        part_.unknown_place.push_back(place);
      }
      return static_cast<int>(unknown[place]);
    };
    for (std::size_t law = 0; law < laws; ++law) {
      SurfaceSites& sites = part_.surface[law].sites;
      for (const std::size_t body : part_.bodies) {
        const Mat<Dim> k = problem_.bodies[body].material.conductivity.template block<Dim>();
        for (const SurfacePiece<Dim>& piece : cut_[body].pieces[law]) {
          Vec3 normal = Vec3::Zero();
          normal.template head<Dim>() = piece.normal;
          const double hold = hold_factor * piece.normal.dot(k * piece.normal) / grid_.cell_size();
          for (const auto& site : piece.quadrature()) {
            const auto row = static_cast<int>(sites.area.size());
            Vec3 position = Vec3::Zero();
            position.template head<Dim>() = site.position;
            sites.position.push_back(position);
            sites.normal.push_back(normal);
            sites.area.push_back(site.weight);
            sites.hold.push_back(hold);
            for_each_node(site.position, [&](Index node, double s) {
              const Index place = part_.rows->place(node);
              if (!part_.followers.follows(place)) {
                entries[law].emplace_back(row, number_of(place), s);
                return;
              }
              for (const auto& leader : part_.followers.leaders(place)) {
                entries[law].emplace_back(row, number_of(leader.place), s * leader.weight);
              }
            });
          }
        }
      }
    }
    for (std::size_t law = 0; law < laws; ++law) {
      SurfaceTerm::Part& part = part_.surface[law];
      part.trace.resize(static_cast<Eigen::Index>(part.sites.area.size()),
                        static_cast<Eigen::Index>(part_.unknown_place.size()));
      part.trace.setFromTriplets(entries[law].begin(), entries[law].end());
    }
  }

  const Points& points_;
  const HeatProblem<Dim>& problem_;
  const Grid<Dim>& grid_;
  CubeLayout layout_;
  const std::vector<CutBody<Dim>>& cut_;
  Function function_;
  HeatPart<Dim> part_;
  std::vector<unsigned char> active_;
  std::vector<std::vector<double>> volume_;  // by body of the part and node
};

}  // namespace

template <int Dim>
std::vector<HeatPart<Dim>> make_parts(const Points& points, const HeatProblem<Dim>& problem,
                                      std::vector<SurfaceFound>& found) {
  std::vector<Shape> shapes;
  for (const HeatBody& body : problem.bodies) {
    check(body.material);
    shapes.push_back(*body.shape);
    check(shapes.back(), Dim);
  }
  const auto& laws = problem.settings.boundaries;
  for (const HeatBoundary& law : laws) {
    if (const Shape* region = region_of(law)) {
      check(*region, Dim);
    }
  }
  found.assign(shapes.size(), {});
  std::vector<CutBody<Dim>> cut;
  std::vector<std::vector<std::size_t>> touching;
  for (std::size_t body = 0; body < shapes.size(); ++body) {
    cut.push_back(cut_body<Dim>(problem, shapes, body, found[body]));
    touching.push_back(cut.back().touching);
  }
  for (std::size_t law = 0; law < laws.size(); ++law) {
    require(std::any_of(cut.begin(), cut.end(),
                        [&](const CutBody<Dim>& body) { return !body.pieces[law].empty(); }),
            "heat.boundaries.", law, " (", name_of_law(laws[law], law), ") selects no surface: ",
            region_of(laws[law]) != nullptr
                ? "its region covers none that an earlier condition left"
                : "earlier conditions took all of it");
  }
  std::vector<HeatPart<Dim>> parts;
  with_shape(problem.shape, resting_half_width, [&](auto function) {
    for (auto& bodies : groups_of(touching)) {
      parts.push_back(
          Assembly<Dim, decltype(function)>(points, problem, cut, std::move(bodies), function)
              .make(found));
    }
  });
  return parts;
}

#define LAPILLI_INSTANTIATE(Dim)                                                         \
  template std::vector<HeatPart<Dim>> make_parts(const Points&, const HeatProblem<Dim>&, \
                                                 std::vector<SurfaceFound>&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
