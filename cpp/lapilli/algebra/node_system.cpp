#include "lapilli/algebra/node_system.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
bool NodeSystem<Dim>::lay_out(const Grid<Dim>& grid, std::vector<CellBox<Dim>> boxes) {
  std::sort(boxes.begin(), boxes.end());
  boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
  if (boxes == boxes_) {
    return false;
  }
  boxes_ = std::move(boxes);
  number(grid, couple(grid));
  return true;
}

/// Number the nodes of all boxes as the grid does, and say who is coupled to whom.
template <int Dim>
NodeGraph NodeSystem<Dim>::couple(const Grid<Dim>& grid) {
  row_.assign(grid.node_count(), -1);
  for (const CellBox<Dim>& box : boxes_) {
    for_each_node(grid, box, [&](int, Index node) { row_[node] = 0; });
  }
  nodes_.clear();
  for (Index node = 0; node < grid.node_count(); ++node) {
    if (row_[node] == 0) {
      row_[node] = static_cast<int>(nodes_.size());
      nodes_.push_back(node);
    }
  }
  std::vector<Index> room(nodes_.size() + 1, 0);
  std::vector<int> rows;
  for (const CellBox<Dim>& box : boxes_) {
    const int count = box.node_count();
    for_each_node(grid, box, [&](int, Index node) { room[row_[node] + 1] += count; });
  }
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    room[k + 1] += room[k];
  }
  std::vector<int> all(room.back());
  std::vector<Index> next(room.begin(), room.end() - 1);
  for (const CellBox<Dim>& box : boxes_) {
    rows.resize(box.node_count());
    this->rows(grid, box, rows.data());
    for (int a : rows) {
      for (int b : rows) {
        all[next[a]++] = b;
      }
    }
  }
  NodeGraph graph;
  graph.start.push_back(0);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const auto begin = all.begin() + room[k], end = all.begin() + room[k + 1];
    std::sort(begin, end);
    graph.neighbour.insert(graph.neighbour.end(), begin, std::unique(begin, end));
    graph.start.push_back(static_cast<Index>(graph.neighbour.size()));
  }
  return graph;
}

/// Renumber for elimination and build the pattern of the lower triangle.
template <int Dim>
void NodeSystem<Dim>::number(const Grid<Dim>& grid, NodeGraph graph) {
  const int count = graph.size();
  std::vector<std::array<int, 3>> place(count, {0, 0, 0});
  for (int k = 0; k < count; ++k) {
    const auto node = grid.node_at(nodes_[k]);
    std::copy(node.begin(), node.end(), place[k].begin());
  }
  const Elimination elimination = nested_dissection(graph, place);
  const std::vector<int>& order = elimination.order;
  part_start_.clear();
  for (int start : elimination.part_start) {
    part_start_.push_back(Dim * start);
  }
  std::vector<int> new_row(count);
  std::vector<Index> new_nodes(count);
  for (int k = 0; k < count; ++k) {
    new_row[order[k]] = k;
    new_nodes[k] = nodes_[order[k]];
  }
  nodes_ = std::move(new_nodes);
  for (int k = 0; k < count; ++k) {
    row_[nodes_[k]] = k;
  }

  start_.assign(1, 0);
  below_.clear();
  for (int k = 0; k < count; ++k) {
    const auto begin = static_cast<std::ptrdiff_t>(below_.size());
    for (int neighbour : graph.of(order[k])) {
      if (new_row[neighbour] >= k) {
        below_.push_back(new_row[neighbour]);
      }
    }
    std::sort(below_.begin() + begin, below_.end());
    start_.push_back(static_cast<Index>(below_.size()));
  }

  const Index entries = Dim * Dim * static_cast<Index>(below_.size()) - count * Dim * (Dim - 1) / 2;
  require(entries < (Index{1} << 31), "the quasi-static matrix has ", entries,
          " entries; at most 2^31: take larger cells");
  lower_.resize(Dim * count, Dim * count);
  lower_.resizeNonZeros(entries);
  int at = 0;
  for (int k = 0; k < count; ++k) {
    for (int c = 0; c < Dim; ++c) {
      lower_.outerIndexPtr()[Dim * k + c] = at;
      for (Index j = start_[k]; j < start_[k + 1]; ++j) {
        for (int r = j == start_[k] ? c : 0; r < Dim; ++r) {
          lower_.innerIndexPtr()[at++] = Dim * below_[j] + r;
        }
      }
    }
  }
  lower_.outerIndexPtr()[Dim * count] = at;
  dropped_.assign(Dim * count, 0);
}

template <int Dim>
void NodeSystem<Dim>::add(const int* rows, int count, const double* matrix) {
  const int width = count * Dim;
  for (int b = 0; b < count; ++b) {
    const int column = rows[b];
    const auto begin = below_.begin() + start_[column], end = below_.begin() + start_[column + 1];
    for (int a = 0; a < count; ++a) {
      if (rows[a] < column) {
        continue;
      }
      const auto j = static_cast<int>(std::lower_bound(begin, end, rows[a]) - begin);
      for (int c = 0; c < Dim; ++c) {
        double* values = lower_.valuePtr() + lower_.outerIndexPtr()[Dim * column + c] + j * Dim - c;
        for (int r = j == 0 ? c : 0; r < Dim; ++r) {
          values[r] += matrix[(a * Dim + r) * width + b * Dim + c];
        }
      }
    }
  }
}

template <int Dim>
void NodeSystem<Dim>::drop_unknowns(double least, double pivot) {
  bool any = false;
  for (int column = 0; column < lower_.cols(); ++column) {
    dropped_[column] = std::abs(lower_.valuePtr()[lower_.outerIndexPtr()[column]]) < least;
    any = any || dropped_[column];
  }
  if (!any) {
    return;
  }
  for (int column = 0; column < lower_.cols(); ++column) {
    for (SparseMatrix::InnerIterator entry(lower_, column); entry; ++entry) {
      if (dropped_[column] || dropped_[entry.row()]) {
        entry.valueRef() = entry.row() == column ? pivot : 0.0;
      }
    }
  }
}

template class NodeSystem<2>;
template class NodeSystem<3>;

}  // namespace lapilli
