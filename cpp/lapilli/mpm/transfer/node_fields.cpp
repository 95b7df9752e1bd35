#include "lapilli/mpm/transfer/node_fields.hpp"

#include <algorithm>

namespace lapilli {

template <int Dim>
NodeFields<Dim>::NodeFields(const Grid<Dim>& grid) : whole_(grid), fields_{{grid, {}, 0}} {}

template <int Dim>
void NodeFields<Dim>::split(std::vector<int> field_of_body) {
  field_of_body_ = std::move(field_of_body);
  const int count = field_of_body_.empty() ? 1 : 1 + *std::ranges::max_element(field_of_body_);
  fields_.assign(static_cast<std::size_t>(count), {whole_, {}, 0});
  for (int field = 1; field < count; ++field) {
    fields_[field].offset = fields_[field - 1].end();
  }
}

/// `lowest`: cell of the whole grid, its padding counted; `cells`: how many along every axis.
template <int Dim>
void NodeFields<Dim>::set_window(int field, const std::array<int, Dim>& lowest,
                                 const std::array<int, Dim>& cells) {
  constexpr int padding = Grid<Dim>::padding;
  const double h = whole_.cell_size();
  Vec<Dim> lower, upper;
  for (int axis = 0; axis < Dim; ++axis) {
    lower[axis] = whole_.lower()[axis] + (lowest[axis] - padding) * h;
    upper[axis] = lower[axis] + cells[axis] * h;
    fields_[field].corner[axis] = lowest[axis] - padding;
  }
  fields_[field].grid = Grid<Dim>(lower, upper, h);
  fields_[field].offset = field == 0 ? 0 : fields_[field - 1].end();
}

template <int Dim>
void NodeFields<Dim>::place(const Points& points) {
  if (is_single()) {
    return;
  }
  std::vector<std::array<int, Dim>> lowest(fields_.size()), highest(fields_.size());
  for (auto& corner : lowest) {
    corner = whole_.cell_at(whole_.cell_count() - 1);
  }
  for (Index row = 0; row < points.size(); ++row) {
    const int field = field_of_body_[points.body()[row]];
    const auto cell = whole_.cell_containing(points.position<Dim>(row));
    for (int axis = 0; axis < Dim; ++axis) {
      lowest[field][axis] = std::min(lowest[field][axis], cell[axis]);
      highest[field][axis] = std::max(highest[field][axis], cell[axis]);
    }
  }
  for (int field = 0; field < count(); ++field) {
    std::array<int, Dim> cells;
    for (int axis = 0; axis < Dim; ++axis) {
      cells[axis] = std::max(1, highest[field][axis] - lowest[field][axis] + 1);
    }
    set_window(field, lowest[field], cells);
  }
}

template <int Dim>
Index NodeFields<Dim>::node_in(int field, Index node) const {
  const NodeField<Dim>& window = fields_[field];
  auto at = whole_.node_at(node);
  for (int axis = 0; axis < Dim; ++axis) {
    at[axis] -= window.corner[axis];
    if (at[axis] < 0 || at[axis] >= window.grid.nodes(axis)) {
      return -1;
    }
  }
  return window.offset + window.grid.node_index(at);
}

template <int Dim>
void NodeFields<Dim>::save(Archive& archive, const std::string& name) const {
  std::vector<Index> numbers;
  for (const NodeField<Dim>& field : fields_) {
    for (int axis = 0; axis < Dim; ++axis) {
      numbers.push_back(field.corner[axis] + Grid<Dim>::padding);
      numbers.push_back(field.grid.cells(axis) - 2 * Grid<Dim>::padding);
    }
  }
  archive.write(name + "/windows", std::span<const Index>(numbers));
  const std::vector<Index> groups(field_of_body_.begin(), field_of_body_.end());
  archive.write(name + "/of_body", std::span<const Index>(groups));
}

template <int Dim>
void NodeFields<Dim>::load(const Archive& archive, const std::string& name) {
  const std::vector<Index> groups = archive.read_indices(name + "/of_body");
  split(std::vector<int>(groups.begin(), groups.end()));
  const std::vector<Index> numbers = archive.read_indices(name + "/windows");
  for (int field = 0; field < count(); ++field) {
    std::array<int, Dim> lowest, cells;
    for (int axis = 0; axis < Dim; ++axis) {
      lowest[axis] = static_cast<int>(numbers[2 * (field * Dim + axis)]);
      cells[axis] = static_cast<int>(numbers[2 * (field * Dim + axis) + 1]);
    }
    set_window(field, lowest, cells);
  }
}

template class NodeFields<1>;
template class NodeFields<2>;
template class NodeFields<3>;

}  // namespace lapilli
