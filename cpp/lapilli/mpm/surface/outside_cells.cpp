#include <algorithm>
#include <atomic>
#include <functional>

#include "lapilli/core/parallel.hpp"
#include "lapilli/mpm/surface/nodal_surface.hpp"

namespace lapilli {
namespace {

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
  const auto cell_of = [&](Index row) {
    return grid_.cell_index(grid_.cell_containing(points.position<Dim>(row)));
  };
  if (bodies_ == 1) {
    parallel_for(points.size(), [&](Index row) {
      std::atomic_ref(occupied_[cell_of(row)]).store(1, std::memory_order_relaxed);
    });
    return;
  }
  body_.assign(occupied_.size(), none);
  for (Index row = 0; row < points.size(); ++row) {
    const Index cell = cell_of(row);
    occupied_[cell] = 1;
    const int body = static_cast<int>(points.body()[row]);
    body_[cell] = body_[cell] == none || body_[cell] == body ? body : shared;
  }
}

template <int Dim>
int OutsideCells<Dim>::body_beside(Index node) const {
  if (bodies_ == 1) {
    return 0;
  }
  const auto at = grid_.node_at(node);
  for (int ring = 1; ring <= 2; ++ring) {
    const int width = 2 * ring, cells = Dim == 1   ? width
                                        : Dim == 2 ? width * width
                                                   : width * width * width;
    for (int k = 0; k < cells; ++k) {
      auto cell = at;
      bool inside = true;
      for (int axis = 0, rest = k; axis < Dim; ++axis, rest /= width) {
        cell[axis] += rest % width - ring;
        inside = inside && cell[axis] >= 0 && cell[axis] < grid_.cells(axis);
      }
      if (const int body = inside ? body_[grid_.cell_index(cell)] : none; body >= 0) {
        return body;
      }
    }
  }
  return -1;
}

template <int Dim>
void OutsideCells<Dim>::close() {
  closed_ = occupied_;
  for (int body = 0; body < bodies_; ++body) {
    // Dilated and eroded by a box of three cells, an axis at a time. The padding keeps points away
    // from the ends of the numbering, where neighbours would be those of another row.
    std::vector<unsigned char> cells = occupied_;
    if (bodies_ > 1) {
      for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        cells[cell] = body_[cell] == body || body_[cell] == shared;
      }
    }
    sweep(cells, std::bit_or<>());
    sweep(cells, std::bit_and<>());
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      closed_[cell] |= cells[cell];
    }
  }
}

template <int Dim>
template <class Combine>
void OutsideCells<Dim>::sweep(std::vector<unsigned char>& cells, const Combine& combine) {
  std::vector<unsigned char> swept(cells.size(), 0);
  for (int axis = 0; axis < Dim; ++axis) {
    const Index stride = grid_.cell_stride(axis);
    const unsigned char* from = cells.data() + stride;
    unsigned char* to = swept.data() + stride;
    parallel_for(
        grid_.cell_count() - 2 * stride,
        [=](Index k) {
          to[k] = static_cast<unsigned char>(
              combine(combine(from[k - stride], from[k]), from[k + stride]));
        },
        Work::light);
    std::fill_n(swept.begin(), stride, 0);
    std::fill_n(swept.end() - stride, stride, 0);
    cells.swap(swept);
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
