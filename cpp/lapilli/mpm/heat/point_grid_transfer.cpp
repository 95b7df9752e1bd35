#include "lapilli/mpm/heat/point_grid_transfer.hpp"

#include <algorithm>

#include "lapilli/mpm/row_weights.hpp"

namespace lapilli {
namespace {

constexpr Index padding = 4;  // a row load may reach past the last node

/// Rows of four nodes held in registers while consecutive points share their lowest node.
template <int Dim, int Rows, int Arrays>
class HeldRows {
 public:
  HeldRows(const Grid<Dim>& grid, const std::array<double*, Arrays>& arrays)
      : stride_{1, Dim > 1 ? grid.node_stride(Dim > 1 ? 1 : 0) : 0,
                Dim > 2 ? grid.node_stride(Dim > 2 ? 2 : 0) : 0},
        arrays_(arrays) {}

  void hold(Index first) {
    if (first != first_) {
      flush();
      first_ = first;
    }
  }
  void flush() {
    if (first_ < 0) {
      return;
    }
    for (int array = 0; array < Arrays; ++array) {
      for (int row = 0; row < Rows; ++row) {
        double* at = arrays_[array] + first_ + offset(row);
        store_quad(at, load_quad(at) + held[array][row]);
        held[array][row] = Quad{};
      }
    }
  }

  Quad held[Arrays][Rows] = {};

 private:
  Index offset(int row) const {
    if constexpr (Dim == 1) {
      return 0;
    } else if constexpr (Dim == 2) {
      return row * stride_[1];
    } else {
      constexpr int support = Rows == 4 ? 2 : 3;
      return (row % support) * stride_[1] + (row / support) * stride_[2];
    }
  }

  Index stride_[3];
  std::array<double*, Arrays> arrays_;
  Index first_ = -1;
};

/// Distances of four nodes from the lowest one, m.
inline Quad lane_distances(double h) { return Quad{0.0, h, 2.0 * h, 3.0 * h}; }

}  // namespace

template <int Dim>
PointGridTransfer<Dim>::PointGridTransfer(const Grid<Dim>& grid, ShapeFunction shape,
                                          const HeatCoefficients<Dim>& coefficients,
                                          bool with_surface)
    : grid_(grid), shape_(shape), coefficients_(coefficients), with_surface_(with_surface) {
  const auto nodes = static_cast<std::size_t>(grid.node_count() + padding);
  for (auto* values : {&capacity, &temperature, &rate, &increment, &blended}) {
    values->assign(nodes, 0.0);
  }
  if (with_surface) {
    sums.fraction.assign(nodes, 0.0);
    sums.area_vector.assign(nodes, Vec<Dim>::Zero());
    for (auto& values : area_) {
      values.assign(nodes, 0.0);
    }
  }
}

/// Calls body(shape_of), where shape_of(b) is the shape function of body b.
template <int Dim>
template <class Body>
void PointGridTransfer<Dim>::with_shapes(const Body& body) const {
  if (shape_ == ShapeFunction::linear) {
    body([](Index) { return LinearShape{}; });
  } else {
    body([widths = coefficients_.half_width.data()](Index b) { return GimpShape{widths[b]}; });
  }
}

template <int Dim>
void PointGridTransfer<Dim>::clear(const CellOrder<Dim>& order) {
  const auto clear_range = [this](Index begin, Index end) {
    for (auto* values : {&capacity, &temperature, &rate, &increment}) {
      std::fill(values->begin() + begin, values->begin() + end, 0.0);
    }
    if (with_surface_) {
      std::fill(sums.fraction.begin() + begin, sums.fraction.begin() + end, 0.0);
      std::fill(sums.area_vector.begin() + begin, sums.area_vector.begin() + end,
                Vec<Dim>(Vec<Dim>::Zero()));
      for (auto& values : area_) {
        std::fill(values.begin() + begin, values.begin() + end, 0.0);
      }
    }
  };
  parallel_ranges(last_ - first_,
                  [&](Index begin, Index end) { clear_range(first_ + begin, first_ + end); });
  const auto [from, to] = order.node_layers();
  const Index layer = grid_.node_stride(Dim - 1);
  first_ = from * layer;
  last_ = std::min(to * layer, grid_.node_count());
}

template <int Dim>
void PointGridTransfer<Dim>::project(const Points& points, const CellOrder<Dim>& order,
                                     const double* point_capacity, const double* carried,
                                     const double* gradient) {
  clear(order);
  const double* position = points.position().data();
  const double* volume = points.volume().data();
  const Index* body = points.body().data();
  const double per_cell = 1.0 / grid_.cell_volume();
  const Quad lanes = lane_distances(grid_.cell_size());
  const double h = grid_.cell_size();
  with_shapes([&](auto shape_of) {
    using PointShape = decltype(shape_of(0));
    using Rows = RowWeights<Dim, PointShape>;
    order.for_each_strip([&, shape_of](Index begin, Index end) {
      HeldRows<Dim, Rows::rows, 2> sum(grid_, {capacity.data(), temperature.data()});
      for (Index row = begin; row < end; ++row) {
        const Rows w(grid_, shape_of(body[row]), position + row * Dim);
        sum.hold(w.first);
        const double m = point_capacity[row];
        if (gradient == nullptr) {
          const double heat = m * carried[row];
          w.for_each_row(grid_, [&](int r, Index, double across) {
            sum.held[0][r] += w.along * (across * m);
            sum.held[1][r] += w.along * (across * heat);
          });
        } else {
          const double* g = gradient + row * Dim;
          // T_p + G_p . (x_I - x_p) along a row: constant plus slope times the lane's distance.
          const Quad tilted = w.along * ((lanes - w.from_base[0]) * g[0]);
          w.for_each_row(grid_, [&](int r, Index, double across) {
            double constant = carried[row];
            if constexpr (Dim >= 2) {
              constant += g[1] * ((r % Rows::support) * h - w.from_base[1]);
            }
            if constexpr (Dim == 3) {
              constant += g[2] * ((r / Rows::support) * h - w.from_base[2]);
            }
            sum.held[0][r] += w.along * (across * m);
            sum.held[1][r] += (w.along * constant + tilted) * (across * m);
          });
        }
      }
      sum.flush();
      if (with_surface_) {
        std::array<double*, 1 + Dim> arrays{sums.fraction.data()};
        for (int axis = 0; axis < Dim; ++axis) {
          arrays[1 + axis] = area_[axis].data();
        }
        HeldRows<Dim, Rows::rows, 1 + Dim> surface(grid_, arrays);
        for (Index row = begin; row < end; ++row) {
          const Rows w(grid_, shape_of(body[row]), position + row * Dim);
          surface.hold(w.first);
          const double v = volume[row];
          w.for_each_row(grid_, [&](int r, Index, double across) {
            surface.held[0][r] += w.along * (across * v * per_cell);
            surface.held[1][r] += w.along_slope * (across * v);
            for (int axis = 1; axis < Dim; ++axis) {
              surface.held[1 + axis][r] += w.along * (w.slope_across(r, axis) * v);
            }
          });
        }
        surface.flush();
      }
    });
  });
  for_active_nodes([this](Index begin, Index end) {
    for (Index node = begin; node < end; ++node) {
      temperature[node] = capacity[node] > 0.0 ? temperature[node] / capacity[node] : 0.0;
    }
    if (with_surface_) {
      for (Index node = begin; node < end; ++node) {
        for (int axis = 0; axis < Dim; ++axis) {
          sums.area_vector[node][axis] = area_[axis][node];
        }
      }
    }
  });
}

template <int Dim>
void PointGridTransfer<Dim>::conduct(const Points& points, const CellOrder<Dim>& order) {
  const double* position = points.position().data();
  const double* volume = points.volume().data();
  const Index* body = points.body().data();
  with_shapes([&](auto shape_of) {
    using PointShape = decltype(shape_of(0));
    using Rows = RowWeights<Dim, PointShape>;
    order.for_each_strip([&, shape_of](Index begin, Index end) {
      HeldRows<Dim, Rows::rows, 1> sum(grid_, {rate.data()});
      for (Index row = begin; row < end; ++row) {
        const Rows w(grid_, shape_of(body[row]), position + row * Dim);
        sum.hold(w.first);
        // Temperature along the row's lanes, and its slopes across.
        Quad level{}, slope[Dim] = {};
        w.for_each_row(grid_, [&](int r, Index offset, double across) {
          const Quad nodes = load_quad(temperature.data() + w.first + offset);
          level += nodes * across;
          for (int axis = 1; axis < Dim; ++axis) {
            slope[axis] += nodes * w.slope_across(r, axis);
          }
        });
        Quad gradient_parts[4] = {w.along_slope * level, Quad{}, Quad{}, Quad{}};
        for (int axis = 1; axis < Dim; ++axis) {
          gradient_parts[axis] = w.along * slope[axis];
        }
        const Quad added = lapilli::sums(gradient_parts[0], gradient_parts[1], gradient_parts[2],
                                         gradient_parts[3]);
        Vec<Dim> gradient;
        for (int axis = 0; axis < Dim; ++axis) {
          gradient[axis] = added[axis];
        }
        const Vec<Dim> flux = volume[row] * (coefficients_.conductivity[body[row]] * gradient);
        const Quad along_part = w.along_slope * flux[0];
        w.for_each_row(grid_, [&](int r, Index, double across) {
          double across_part = 0.0;
          for (int axis = 1; axis < Dim; ++axis) {
            across_part += w.slope_across(r, axis) * flux[axis];
          }
          sum.held[0][r] -= along_part * across + w.along * across_part;
        });
      }
      sum.flush();
    });
  });
}

template <int Dim>
void PointGridTransfer<Dim>::update(const Points& points, const std::vector<double>& nodal,
                                    double beta, double* carried, double* carried_gradient) {
  const double* position = points.position().data();
  const Index* body = points.body().data();
  const double keep = 1.0 - beta;
  with_shapes([&](auto shape_of) {
    using PointShape = decltype(shape_of(0));
    using Rows = RowWeights<Dim, PointShape>;
    parallel_for(points.size(), [&, shape_of](Index row) {
      const Rows w(grid_, shape_of(body[row]), position + row * Dim);
      Quad level{}, slope[Dim] = {};
      w.for_each_row(grid_, [&](int r, Index offset, double across) {
        const Quad nodes = load_quad(nodal.data() + w.first + offset);
        level += nodes * across;
        if (carried_gradient != nullptr) {
          for (int axis = 1; axis < Dim; ++axis) {
            slope[axis] += nodes * w.slope_across(r, axis);
          }
        }
      });
      Quad parts[4] = {w.along * level, Quad{}, Quad{}, Quad{}};
      if (carried_gradient == nullptr) {
        carried[row] =
            keep * carried[row] + (parts[0][0] + parts[0][1]) + (parts[0][2] + parts[0][3]);
        return;
      }
      parts[1] = w.along_slope * level;
      for (int axis = 1; axis < Dim; ++axis) {
        parts[1 + axis] = w.along * slope[axis];
      }
      const Quad added = lapilli::sums(parts[0], parts[1], parts[2], parts[3]);
      carried[row] = keep * carried[row] + added[0];
      for (int axis = 0; axis < Dim; ++axis) {
        double& g = carried_gradient[row * Dim + axis];
        g = keep * g + added[1 + axis];
      }
    });
  });
}

template <int Dim>
void PointGridTransfer<Dim>::interpolate(const Points& points, const std::vector<double>& nodal,
                                         double* value, double* flux) {
  std::fill_n(value, points.size(), 0.0);
  std::fill_n(flux, points.size() * Dim, 0.0);
  update(points, nodal, 1.0, value, flux);
  parallel_for(points.size(), [&](Index row) {
    Eigen::Map<Vec<Dim>> q(flux + row * Dim);
    q = Vec<Dim>(-(coefficients_.conductivity[points.body()[row]] * q));
  });
}

template class PointGridTransfer<1>;
template class PointGridTransfer<2>;
template class PointGridTransfer<3>;

}  // namespace lapilli
