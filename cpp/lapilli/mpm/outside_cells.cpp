#include <algorithm>
#include <array>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/nodal_surface.hpp"

namespace lapilli {
namespace {

/// Offsets in the numbering of cells to a cell and its 3^Dim - 1 neighbours.
template <int Dim>
std::vector<Index> block_offsets(const Grid<Dim>& grid) {
  std::vector<Index> offsets{0};
  for (int axis = 0; axis < Dim; ++axis) {
    const std::vector<Index> before = offsets;
    for (const Index step : {-grid.cell_stride(axis), grid.cell_stride(axis)}) {
      for (const Index offset : before) {
        offsets.push_back(offset + step);
      }
    }
  }
  return offsets;
}

/// Whether a cell lies at least `margin` cells inside the padded grid.
template <int Dim>
bool is_inner(const Grid<Dim>& grid, Index cell, int margin) {
  const auto at = grid.cell_at(cell);
  for (int axis = 0; axis < Dim; ++axis) {
    if (at[axis] < margin || at[axis] >= grid.cells(axis) - margin) {
      return false;
    }
  }
  return true;
}

}  // namespace

template <int Dim>
void OutsideCells<Dim>::mark_occupied(const Points& points) {
  occupied_.assign(static_cast<std::size_t>(grid_.cell_count()), 0);
  if (bodies_ > 1) {
    body_.assign(occupied_.size(), -1);
  }
  for (Index row = 0; row < points.size(); ++row) {
    const Index cell = grid_.cell_index(grid_.cell_containing(points.position<Dim>(row)));
    occupied_[cell] = 1;
    if (bodies_ > 1) {
      // A cell that two bodies share belongs to both: -2.
      const int body = static_cast<int>(points.body()[row]);
      body_[cell] = body_[cell] == -1 || body_[cell] == body ? body : -2;
    }
  }
}

template <int Dim>
void OutsideCells<Dim>::close() {
  closed_ = occupied_;
  const auto offsets = block_offsets(grid_);
  const Index count = grid_.cell_count();
  // Only an empty cell beside an occupied one can be closed.
  std::vector<Index> candidates;
  for (Index cell = 0; cell < count; ++cell) {
    if (occupied_[cell] != 0) {
      for (const Index offset : offsets) {
        if (occupied_[cell + offset] == 0) {
          candidates.push_back(cell + offset);
        }
      }
    }
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  const auto near_body = [&](Index cell, int body) {
    return std::any_of(offsets.begin(), offsets.end(), [&](Index offset) {
      const Index at = cell + offset;
      return occupied_[at] != 0 && (bodies_ == 1 || body_[at] == body || body_[at] == -2);
    });
  };
  for (const Index cell : candidates) {
    if (!is_inner(grid_, cell, 2)) {
      continue;
    }
    for (int body = 0; body < bodies_ && closed_[cell] == 0; ++body) {
      closed_[cell] = std::all_of(offsets.begin(), offsets.end(),
                                  [&](Index offset) { return near_body(cell + offset, body); });
    }
  }
}

template <int Dim>
void OutsideCells<Dim>::flood() {
  queue_.clear();
  for (Index cell = 0; cell < grid_.cell_count(); ++cell) {
    if (outside_[cell] != 0) {
      queue_.push_back(cell);
    }
  }
  for (std::size_t head = 0; head < queue_.size(); ++head) {
    const auto at = grid_.cell_at(queue_[head]);
    for (int axis = 0; axis < Dim; ++axis) {
      for (const int side : {-1, 1}) {
        const int to = at[axis] + side;
        const Index cell = queue_[head] + side * grid_.cell_stride(axis);
        if (to >= 0 && to < grid_.cells(axis) && outside_[cell] == 0 && closed_[cell] == 0) {
          outside_[cell] = 1;
          queue_.push_back(cell);
        }
      }
    }
  }
  for (const Index cell : queue_) {
    outside_[cell] = closed_[cell] != 0 ? narrow : open;
  }
}

template <int Dim>
void OutsideCells<Dim>::start(const Points& points, const DistanceFunction& distance) {
  mark_occupied(points);
  close();
  outside_.assign(occupied_.size(), 0);
  for (Index cell = 0; cell < grid_.cell_count(); ++cell) {
    if (occupied_[cell] != 0) {
      continue;
    }
    if (!is_inner(grid_, cell, 1)) {
      outside_[cell] = 1;
    } else if (distance) {
      Vec3 centre = Vec3::Zero();
      const auto at = grid_.cell_at(cell);
      for (int axis = 0; axis < Dim; ++axis) {
        centre[axis] = grid_.origin()[axis] + (at[axis] + 0.5) * grid_.cell_size();
      }
      outside_[cell] = distance(centre) >= 0.0;
    } else {
      // Points alone: a void that survives the closing is one, smaller gaps are not.
      outside_[cell] = closed_[cell] == 0;
    }
  }
  flood();
}

template <int Dim>
void OutsideCells<Dim>::follow(const Points& points) {
  mark_occupied(points);
  close();
  for (Index cell = 0; cell < grid_.cell_count(); ++cell) {
    outside_[cell] = occupied_[cell] != 0 ? 0 : outside_[cell];
  }
  take_in_swept();
  flood();
}

template <int Dim>
void OutsideCells<Dim>::take_in_swept() {
  // Two passes: rows of cells between points, then where such rows cross.
  const auto is_inside = [&](Index cell) { return closed_[cell] != 0 && outside_[cell] == 0; };
  std::vector<Index> swept;
  for (int pass = 0; pass < 2; ++pass) {
    swept.clear();
    for (Index cell = 0; cell < grid_.cell_count(); ++cell) {
      if (outside_[cell] != open || closed_[cell] == 0) {
        continue;
      }
      for (int axis = 0; axis < Dim; ++axis) {
        const Index stride = grid_.cell_stride(axis);
        if (is_inside(cell - stride) && is_inside(cell + stride)) {
          swept.push_back(cell);
          break;
        }
      }
    }
    for (const Index cell : swept) {
      outside_[cell] = 0;
    }
  }
}

template <int Dim>
void OutsideCells<Dim>::save(Archive& archive, const std::string& name) const {
  const std::vector<Index> flags(outside_.begin(), outside_.end());
  archive.write(name, std::span<const Index>(flags));
}

template <int Dim>
void OutsideCells<Dim>::load(const Archive& archive, const std::string& name) {
  std::vector<Index> flags(static_cast<std::size_t>(grid_.cell_count()));
  archive.read(name, std::span<Index>(flags));
  outside_.assign(flags.begin(), flags.end());
}

template class OutsideCells<1>;
template class OutsideCells<2>;
template class OutsideCells<3>;

}  // namespace lapilli
