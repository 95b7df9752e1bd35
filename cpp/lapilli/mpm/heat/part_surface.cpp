#include "lapilli/mpm/heat/part_surface.hpp"

#include <algorithm>
#include <limits>

#include "lapilli/mpm/heat/start_in_shape.hpp"
#include "lapilli/mpm/surface/cut_shape.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {
namespace {

// Both sides of a contact have their own layer, thin, and exchange does not pass it.
constexpr double thin_of_contact = 1.0 / 300.0;  // cells

// What a layer takes from the order of temperatures beside it shows where Kirchhoff's slab is
// curved: order 1.71 from 20 to 40 cells, 1.81 with a layer of this share, which locks by 2 % in a
// square at 45 degrees 7 cells across and .3 % at 14, the whole by 0.1 %.
constexpr double share_of_nonlinear = 0.3;

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Numbers things as they are met.
class Numbers {
 public:
  explicit Numbers(Index size) : number_(static_cast<std::size_t>(size), -1) {}
  int of(Index place, std::vector<Index>& met) {
    if (number_[place] < 0) {
      number_[place] = static_cast<Index>(met.size());
      met.push_back(place);
    }
    return static_cast<int>(number_[place]);
  }

 private:
  std::vector<Index> number_;
};

/// Through what law number `law` holds or exchanges on these pieces.
template <int Dim>
HoldLayer layer_of(const HeatProblem<Dim>& problem, std::size_t law,
                   const PiecesOfBodies<Dim>& pieces) {
  if (law >= problem.settings.boundaries.size()) {
    return {thin_of_contact, false};
  }
  const HoldLayer layer;
  const HeatBoundary& one = problem.settings.boundaries[law];
  if (is_nonlinear(problem)) {  // one system over all parts: one answer for all
    return {share_of_nonlinear * layer.thickness, passes_layer(one, 0.0)};
  }
  double least = std::numeric_limits<double>::infinity();  // W/(m K), across any piece
  for (const auto& [body, some] : pieces) {
    const Mat<Dim> k = problem.bodies[body].material.conductivity.constant().template block<Dim>();
    for (const SurfacePiece<Dim>& piece : some) {
      least = std::min(least, piece.normal.dot(k * piece.normal));
    }
  }
  return {layer.thickness, passes_layer(one, least / (layer.thickness * problem.grid.cell_size()))};
}

template <int Dim>
bool conductivity_varies(const HeatProblem<Dim>& problem) {
  return std::any_of(problem.bodies.begin(), problem.bodies.end(),
                     [](const HeatBody& body) { return body.material.conductivity.varies(); });
}

template <int Dim, class Function>
void trace_pieces(const HeatProblem<Dim>& problem, const std::vector<PiecesOfBodies<Dim>>& pieces,
                  const Function& function, HeatPart<Dim>& part) {
  const Grid<Dim>& grid = problem.grid;
  const std::size_t laws = pieces.size();
  Numbers numbers(grid.node_count());
  std::vector<Triplets> entries(laws);
  part.surface.resize(laws);
  for (std::size_t law = 0; law < laws; ++law) {
    SurfaceSites& sites = part.surface[law].sites;
    sites.layer = layer_of(problem, law, pieces[law]);
    const double thickness = sites.layer.thickness * grid.cell_size();
    const double depth = sites.layer.behind ? 0.5 * thickness : 0.0;
    const bool renewed = law < problem.settings.boundaries.size() && conductivity_varies(problem);
    sites.depth = thickness;
    for (const auto& [body, some] : pieces[law]) {
      const auto& conductivity = problem.bodies[body].material.conductivity;
      const Mat<Dim> k = conductivity.largest().template block<Dim>();
      for (const SurfacePiece<Dim>& piece : some) {
        Vec3 normal = Vec3::Zero();
        normal.template head<Dim>() = piece.normal;
        const double hold = piece.normal.dot(k * piece.normal) / thickness;
        for (const auto& site : piece.quadrature()) {
          const auto row = static_cast<int>(sites.area.size());
          Vec3 position = Vec3::Zero();
          position.template head<Dim>() = site.position;
          sites.position.push_back(position);
          sites.normal.push_back(normal);
          sites.area.push_back(site.weight);
          sites.hold.push_back(hold);
          if (renewed) {
            sites.conductivity.push_back(conductivity.table());
          }
          const Vec<Dim> seen_at = site.position - depth * piece.normal;
          Weights<Dim, Function>(grid, function, seen_at.data())
              .for_each_node(grid, [&](Index node, double s, const Vec<Dim>&) {
                if (s > 0.0) {
                  entries[law].emplace_back(row, numbers.of(node, part.nodal.node), s);
                }
              });
        }
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(part.nodal.node.size());
  for (std::size_t law = 0; law < laws; ++law) {
    SurfaceTerm::Trace trace(static_cast<Eigen::Index>(part.surface[law].sites.area.size()), count);
    trace.setFromTriplets(entries[law].begin(), entries[law].end());
    part.nodal.trace.push_back(std::move(trace));
  }
}

/// Whether the bodies of a part start at one temperature.
template <int Dim>
bool starts_even(const HeatProblem<Dim>& problem, const std::vector<std::size_t>& bodies) {
  const Value& first = problem.bodies[bodies.front()].temperature;
  return std::ranges::all_of(bodies, [&](std::size_t body) {
    const Value& one = problem.bodies[body].temperature;
    return !one.is_function() && one.at(0.0) == first.at(0.0);
  });
}

/// The volume of every body at every place, where capacities are not constant.
template <int Dim>
void store_volumes(const HeatProblem<Dim>& problem, const std::vector<std::vector<double>>& volume,
                   HeatPart<Dim>& part) {
  part.volume.clear();
  if (!is_nonlinear(problem)) {
    return;
  }
  for (std::size_t k = 0; k < part.bodies.size(); ++k) {
    std::vector<double>& own = part.volume.emplace_back(part.capacity.size(), 0.0);
    for (Index node = 0; node < problem.grid.node_count(); ++node) {
      if (volume[k][node] > 0.0) {
        own[part.rows->place(node)] = volume[k][node];
      }
    }
    part.followers.restrict_to_leaders(own);
  }
}

}  // namespace

template <int Dim>
std::vector<PiecesOfBodies<Dim>> pieces_of_part(const std::vector<CutBody<Dim>>& cut,
                                                std::span<const ResistingContact> contacts,
                                                const std::vector<std::size_t>& bodies) {
  std::vector<PiecesOfBodies<Dim>> all(cut.front().pieces.size());
  for (std::size_t law = 0; law < all.size(); ++law) {
    for (const std::size_t body : bodies) {
      all[law].emplace_back(body, cut[body].pieces[law]);
    }
  }
  for (const ResistingContact& contact : contacts) {
    PiecesOfBodies<Dim>& pieces = all.emplace_back();
    for (const std::size_t body : {contact.first, contact.second}) {
      if (std::find(bodies.begin(), bodies.end(), body) != bodies.end()) {
        pieces.emplace_back(contact.first, cut[contact.first].resisting.at(contact.second));
        break;
      }
    }
  }
  return all;
}

template <int Dim>
void connect_surface(const HeatProblem<Dim>& problem,
                     const std::vector<PiecesOfBodies<Dim>>& pieces, HeatPart<Dim>& part) {
  with_shape(problem.shape, resting_half_width,
             [&](auto function) { trace_pieces<Dim>(problem, pieces, function, part); });
  Numbers numbers(part.rows->size());
  Triplets entries;
  for (std::size_t k = 0; k < part.nodal.node.size(); ++k) {
    const auto row = static_cast<int>(k);
    const Index place = part.rows->place(part.nodal.node[k]);
    part.nodal.place.push_back(place);
    if (!part.followers.follows(place)) {
      entries.emplace_back(row, numbers.of(place, part.unknown_place), 1.0);
      continue;
    }
    for (const auto& leader : part.followers.leaders(place)) {
      entries.emplace_back(row, numbers.of(leader.place, part.unknown_place), leader.weight);
    }
  }
  SurfaceTerm::Trace from_leaders(static_cast<Eigen::Index>(part.nodal.node.size()),
                                  static_cast<Eigen::Index>(part.unknown_place.size()));
  from_leaders.setFromTriplets(entries.begin(), entries.end());
  for (std::size_t law = 0; law < part.surface.size(); ++law) {
    part.surface[law].trace = part.nodal.trace[law] * from_leaders;
  }
}

template <int Dim>
void store_heat(const HeatProblem<Dim>& problem, const std::vector<std::vector<double>>& volume,
                HeatPart<Dim>& part) {
  const auto size = static_cast<std::size_t>(part.rows->size());
  part.capacity.assign(size, 0.0);
  part.temperature.assign(size, 0.0);
  part.sources.clear();
  const bool uniform = starts_even(problem, part.bodies);
  for (std::size_t k = 0; k < part.bodies.size(); ++k) {
    const std::size_t number = part.bodies[k];
    const HeatBody& body = problem.bodies[number];
    const bool heats = !body.source.is_constant() || body.source.at(0.0) != 0.0;
    const double capacity = body.material.capacity();
    typename HeatPart<Dim>::BodyVolume own{number, {}, {}, {}};
    std::vector<Index> nodes;
    for (Index node = 0; node < problem.grid.node_count(); ++node) {
      if (volume[k][node] > 0.0) {
        nodes.push_back(node);
        own.place.push_back(part.rows->place(node));
        own.volume.push_back(volume[k][node]);
        part.capacity[own.place.back()] += capacity * volume[k][node];
      }
    }
    if (!uniform) {
      const std::vector<double> start =
          start_at_nodes<Dim>(body.temperature, *body.shape, problem.grid, nodes, number);
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        part.temperature[own.place[j]] += capacity * own.volume[j] * start[j];
      }
    }
    if (heats) {
      own.position = places_in_shape<Dim>(*body.shape, problem.grid, nodes);
      part.sources.push_back(std::move(own));
    }
  }
  for (std::size_t place = 0; place < size; ++place) {
    if (part.capacity[place] > 0.0) {
      double& value = part.temperature[place];
      value = uniform ? problem.bodies[part.bodies.front()].temperature.at(0.0)
                      : value / part.capacity[place];
    }
  }
  store_volumes(problem, volume, part);
  part.followers.restrict_to_leaders(part.capacity);
  part.followers.prolong(part.temperature);
}

#define LAPILLI_INSTANTIATE(Dim)                                                                  \
  template std::vector<PiecesOfBodies<Dim>> pieces_of_part(const std::vector<CutBody<Dim>>&,      \
                                                           std::span<const ResistingContact>,     \
                                                           const std::vector<std::size_t>&);      \
  template void connect_surface(const HeatProblem<Dim>&, const std::vector<PiecesOfBodies<Dim>>&, \
                                HeatPart<Dim>&);                                                  \
  template void store_heat(const HeatProblem<Dim>&, const std::vector<std::vector<double>>&,      \
                           HeatPart<Dim>&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
