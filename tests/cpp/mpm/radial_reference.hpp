#pragma once

#include <cmath>
#include <vector>

namespace lapilli::scenes {

/// Heat between two radii in the plane, unit material, started at zero: cell-centred finite volumes
/// and Crank-Nicolson after four backward Euler steps. Each side has a coefficient of convection
/// (0: insulated, 1e12: held) and surroundings. With 800 cells its error is below 1e-5.
class RadialReference {
 public:
  struct Side {
    double coefficient = 0.0, ambient = 0.0;
  };

  RadialReference(double inner, double outer, Side in, Side out, double end)
      : inner_(inner), width_((outer - inner) / cells), value_(cells, 0.0) {
    const int steps = 1000;
    for (int step = 0; step < steps; ++step) {
      const bool starting = step < 2;
      const double size = end / steps / (starting ? 2 : 1);
      for (int part = 0; part < (starting ? 2 : 1); ++part) {
        advance(size, starting ? 1.0 : 0.5, in, out);
      }
    }
  }

  /// Linear between cell centres, constant within half a cell of the sides.
  double operator()(double r) const {
    const double at = std::min(std::max((r - inner_) / width_ - 0.5, 0.0), cells - 1.0 - 1e-9);
    const auto k = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(k);
    return (1.0 - share) * value_[k] + share * value_[k + 1];
  }

 private:
  static constexpr int cells = 800;

  void advance(double step, double theta, Side in, Side out) {
    const auto conductance = [&](Side side, double r) {
      return side.coefficient > 0.0 ? r / (0.5 * width_ + 1.0 / side.coefficient) : 0.0;
    };
    const double first = conductance(in, inner_);
    const double last = conductance(out, inner_ + cells * width_);
    std::vector<double> diagonal(cells), upper(cells), right(cells);
    double pivot = 0.0, before = 0.0;
    for (int k = 0; k < cells; ++k) {
      const double r = inner_ + k * width_;
      const double down = k == 0 ? first : r / width_;
      const double up = k == cells - 1 ? last : (r + width_) / width_;
      const double below = k == 0 ? in.ambient : value_[k - 1];
      const double above = k == cells - 1 ? out.ambient : value_[k + 1];
      const double capacity = (r + 0.5 * width_) * width_ / step;
      right[k] = down * (below - value_[k]) + up * (above - value_[k]);  // for the increment
      diagonal[k] = capacity + theta * (down + up);
      upper[k] = k == cells - 1 ? 0.0 : -theta * up;
      if (k > 0) {
        const double factor = -theta * down / pivot;
        diagonal[k] -= factor * upper[k - 1];
        right[k] -= factor * before;
      }
      pivot = diagonal[k];
      before = right[k];
    }
    double increment = 0.0;
    for (int k = cells - 1; k >= 0; --k) {
      increment = (right[k] - upper[k] * increment) / diagonal[k];
      value_[k] += increment;
    }
  }

  double inner_, width_;
  std::vector<double> value_;
};

}  // namespace lapilli::scenes
