#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "lapilli/mpm/heat/cell_operators.hpp"
#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/heat/part_surface.hpp"
#include "lapilli/mpm/heat/shared_cells.hpp"

namespace lapilli {

/// Makes one part.
template <int Dim, class Function>
class PartAssembly {
  using Cell = CellOperators<Dim, Function>;

 public:
  PartAssembly(const Points& points, const HeatProblem<Dim>& problem,
               const std::vector<CutBody<Dim>>& cut, std::span<const ResistingContact> contacts,
               std::vector<std::size_t> bodies, const Function& function)
      : points_(points),
        problem_(problem),
        grid_(problem.grid),
        layout_(problem.shape),
        cut_(cut),
        pieces_(pieces_of_part<Dim>(cut, contacts, bodies)),
        function_(function),
        active_(static_cast<std::size_t>(grid_.node_count()), 0) {
    part_.bodies = std::move(bodies);
    for (int local = 0; local < Cell::nodes; ++local) {
      offset_[local] = grid_.node_index(Cell::steps(local));
    }
    constexpr int width = 2 * Function::support - 1;
    int steps = 1;
    for (int axis = 0; axis < Dim; ++axis) {
      steps *= width;
    }
    for (int number = 0; number < steps; ++number) {
      typename SharedStencil<Dim>::Step step;
      for (int axis = 0, rest = number; axis < Dim; ++axis, rest /= width) {
        step[axis] = rest % width - (Function::support - 1);
      }
      step_.push_back(step);
    }
  }

  HeatPart<Dim> make(std::vector<SurfaceFound>& found) {
    find_volumes(found);
    find_active();
    part_.rows = std::make_unique<NodeRows<Dim>>(grid_, active_, Function::support - 1);
    connect_nodes();
    std::vector<double> all(active_.size(), 0.0);
    for (const auto& volume : volume_) {
      for (std::size_t node = 0; node < all.size(); ++node) {
        all[node] += volume[node];
      }
    }
    part_.followers = Followers<Dim>(grid_, *part_.rows, all, active_);
    store_heat<Dim>(problem_, volume_, part_);
    if (!leaders_keep_capacity(all)) {
      part_.followers = Followers<Dim>(grid_, *part_.rows, all, active_, false);
      store_heat<Dim>(problem_, volume_, part_);
    }
    connect_surface<Dim>(problem_, pieces_, part_);
    found[part_.bodies.front()].followers = static_cast<Index>(part_.followers.count());
    found[part_.bodies.front()].nodes = std::count(active_.begin(), active_.end(), 1);
    return std::move(part_);
  }

 private:
  Cell cell_of(std::size_t body) const {
    const Mat<Dim> k = problem_.bodies[body].material.conductivity.largest().template block<Dim>();
    return Cell(grid_, layout_, function_, k);
  }

  /// The step from one node of a cell to a later one, as a number of `step_`.
  static std::size_t pair(int a, int b) {
    const auto from = Cell::steps(a), to = Cell::steps(b);
    constexpr int width = 2 * Function::support - 1;
    int number = 0;
    for (int axis = Dim - 1; axis >= 0; --axis) {
      number = number * width + to[axis] - from[axis] + Function::support - 1;
    }
    return static_cast<std::size_t>(number);
  }

  void find_volumes(std::vector<SurfaceFound>& found) {
    met_.assign(active_.size(), 0);
    kind_of_node_.assign(active_.size(), SharedStencil<Dim>::own);
    for (std::size_t k = 0; k < part_.bodies.size(); ++k) {
      const std::size_t body = part_.bodies[k];
      Cell cell = cell_of(body);
      std::vector<double>& volume = volume_.emplace_back(active_.size(), 0.0);
      std::vector<int> whole(active_.size(), 0);
      std::map<Index, double>& of_cut = volume_of_cut_.emplace_back();
      for (const CellCut<Dim>& cut : cut_[body].cells) {
        cell.integrate(cut, false);
        if (part_.bodies.size() > 1 && !cell.is_whole(cut)) {
          of_cut[grid_.node_index(cut.node)] = cell.volumes.sum();
        }
        const Index first = grid_.node_index(cell.first_node(cut.node));
        for (int local = 0; local < Cell::nodes; ++local) {
          const Index node = first + offset_[local];
          volume[node] += cell.volumes[local];
          ++met_[node];
          whole[node] += cell.is_whole(cut) ? 1 : 0;
        }
      }
      for (std::size_t node = 0; node < whole.size(); ++node) {
        if (whole[node] == Cell::nodes) {
          kind_of_node_[node] = static_cast<int>(k);
        }
      }
      found[body].volume = std::accumulate(volume.begin(), volume.end(), 0.0);
    }
    for (std::size_t node = 0; node < met_.size(); ++node) {
      if (met_[node] != Cell::nodes) {
        kind_of_node_[node] = SharedStencil<Dim>::own;
      }
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
    for (const auto& of_one : pieces_) {
      for (const auto& [body, pieces] : of_one) {
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
        const auto position = points_.position<Dim>(row);
        const Index nearest = grid_.node_index(grid_.cell_containing(position));
        if (kind_of_node_[nearest] == SharedStencil<Dim>::own) {
          for_each_node(position, activate);
        }
      }
    }
  }

  void connect_nodes() {
    const SharedCells<Dim> shared(problem_, part_.bodies, volume_of_cut_, cut_);
    std::vector<std::size_t> all(part_.bodies.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    part_.conduction = conduction_of(all, kind_of_node_, shared);
    const bool varies = std::any_of(all.begin(), all.end(), [&](std::size_t k) {
      return problem_.bodies[part_.bodies[k]].material.varies();
    });
    for (std::size_t k = 0; varies && all.size() > 1 && k < all.size(); ++k) {
      std::vector<int> kind(kind_of_node_);
      for (int& one : kind) {
        one = one < 0 || one == static_cast<int>(k) ? one : SharedStencil<Dim>::nobody;
      }
      part_.own_conduction.push_back(conduction_of({&k, 1}, kind, shared));
    }
  }

  /// The conduction in some bodies of the part, given by their number in it; `kind` by node.
  std::unique_ptr<SharedStencil<Dim>> conduction_of(std::span<const std::size_t> some,
                                                    std::span<const int> kind_of_node,
                                                    const SharedCells<Dim>& shared) {
    std::vector<int> kind(static_cast<std::size_t>(part_.rows->size()), SharedStencil<Dim>::nobody);
    for (const auto& row : part_.rows->rows()) {
      const Index first = row.grid_row * grid_.nodes(0);
      for (int i = row.begin; i < row.end; ++i) {
        if (active_[first + i] != 0) {
          kind[row.shift + i] = kind_of_node[first + i];
        }
      }
    }
    auto made = std::make_unique<SharedStencil<Dim>>(*part_.rows, std::move(kind),
                                                     static_cast<int>(part_.bodies.size()));
    for (const std::size_t k : some) {
      Cell cell = cell_of(part_.bodies[k]);
      share_row(*made, static_cast<int>(k), cell.whole_conduction());
      for (const CellCut<Dim>& cut : cut_[part_.bodies[k]].cells) {
        add_conduction(*made, cell, cut, k, shared);
      }
    }
    made->agree();
    return made;
  }

  void share_row(SharedStencil<Dim>& conduction, int which,
                 const typename Cell::Conduction& whole) {
    std::vector<double> sum(step_.size(), 0.0);
    for (int a = 0; a < Cell::nodes; ++a) {
      for (int b = a + 1; b < Cell::nodes; ++b) {
        sum[pair(a, b)] += whole(a, b);
      }
    }
    for (std::size_t k = 0; k < sum.size(); ++k) {
      if (sum[k] != 0.0) {
        conduction.share(which, step_[k], sum[k]);
      }
    }
  }

  void add_conduction(SharedStencil<Dim>& conduction, Cell& cell, const CellCut<Dim>& cut,
                      std::size_t which, const SharedCells<Dim>& shared) {
    const Index first = grid_.node_index(cell.first_node(cut.node));
    std::array<Index, Cell::nodes> place;
    bool all_share = cell.is_whole(cut);
    for (int local = 0; local < Cell::nodes; ++local) {
      const Index node = first + offset_[local];
      place[local] = active_[node] != 0 ? part_.rows->place(node) : -1;
      all_share = all_share && kind_of_node_[node] >= 0;
    }
    if (all_share) {
      return;
    }
    const Index node = grid_.node_index(cut.node);
    if (shared.is_shared(node)) {
      const double middle = 0.5 - layout_.shift;  // of the cell, from its node
      const Vec<Dim> center =
          grid_.node_position(node) + Vec<Dim>::Constant(middle * grid_.cell_size());
      cell.integrate(cut, shared.conductivity(which, node, center));
    } else {
      cell.integrate(cut);
    }
    for (int a = 0; a < Cell::nodes; ++a) {
      for (int b = a + 1; b < Cell::nodes && place[a] >= 0; ++b) {
        if (place[b] >= 0 && cell.conduction(a, b) != 0.0) {
          conduction.add(place[a], place[b], step_[pair(a, b)], cell.conduction(a, b));
        }
      }
    }
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

  const Points& points_;
  const HeatProblem<Dim>& problem_;
  const Grid<Dim>& grid_;
  CubeLayout layout_;
  const std::vector<CutBody<Dim>>& cut_;
  std::vector<PiecesOfBodies<Dim>> pieces_;
  Function function_;
  HeatPart<Dim> part_;
  std::vector<unsigned char> active_;
  std::vector<std::vector<double>> volume_;             // by body of the part and node
  std::vector<std::map<Index, double>> volume_of_cut_;  // by body, of cut cells of several bodies
  std::vector<int> met_, kind_of_node_;    // by node: cells that touch it, row of the stencil
  std::array<Index, Cell::nodes> offset_;  // from the first node of a cell
  std::vector<typename SharedStencil<Dim>::Step> step_;  // all within a cell
};

}  // namespace lapilli
