#include "lapilli/geometry/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace lapilli {
namespace {

using Distance = std::function<double(const Vec3&)>;

struct Gauss {
  std::span<const double> place;   // in (0, 1)
  std::span<const double> weight;  // sums to 1
};

Gauss gauss(int points) {
  static constexpr double place_2[] = {0.21132486540518712, 0.78867513459481288};
  static constexpr double weight_2[] = {0.5, 0.5};
  static constexpr double place_3[] = {0.11270166537925831, 0.5, 0.88729833462074169};
  static constexpr double weight_3[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  static constexpr double place_4[] = {0.069431844202973712, 0.33000947820757187,
                                       0.66999052179242813, 0.93056815579702629};
  static constexpr double weight_4[] = {0.17392742256872693, 0.32607257743127307,
                                        0.32607257743127307, 0.17392742256872693};
  static constexpr double place_5[] = {0.046910077030668004, 0.23076534494715846, 0.5,
                                       0.76923465505284154, 0.953089922969332};
  static constexpr double weight_5[] = {0.11846344252809454, 0.23931433524968324,
                                        0.28444444444444444, 0.23931433524968324,
                                        0.11846344252809454};
  switch (points) {
    case 2:
      return {place_2, weight_2};
    case 3:
      return {place_3, weight_3};
    case 4:
      return {place_4, weight_4};
    default:
      return {place_5, weight_5};
  }
}

// The value kept at the other end when two steps fall on one side (Anderson & Bjoerck 1973).
double less_of(double kept, double before, double now) {
  const double share = 1.0 - now / before;
  return kept * (share > 0.0 ? share : 0.5);
}

// Where the distance changes sign between two values of opposite sign: regula falsi, to rounding.
template <class Along>
double sign_change(const Along& along, double a, double fa, double b, double fb) {
  const double fine = 4e-16 * (std::abs(a) + std::abs(b) + (b - a));
  double root = a, last = a;
  for (int step = 0; step < 100 && b - a > fine; ++step) {
    const bool halve = step % 6 == 5;
    root = halve ? 0.5 * (a + b) : a - fa * (b - a) / (fb - fa);
    if (!halve && step > 0 && std::abs(root - last) < fine) {
      break;
    }
    last = root;
    const double f = along(root);
    if (f == 0.0) {
      break;
    }
    if ((f > 0.0) == (fb > 0.0)) {
      fa = less_of(fa, fb, f);
      b = root;
      fb = f;
    } else {
      fb = less_of(fb, fa, f);
      a = root;
      fa = f;
    }
  }
  return root;
}

// Sign changes on [a, b] in order, looked for in halves of halves where the distance does not
// exclude them.
template <class Along>
void sign_changes(const Along& along, double a, double fa, double b, double fb, int halvings,
                  std::vector<double>& roots) {
  const bool differ = (fa > 0.0) != (fb > 0.0);
  const bool decided =
      differ ? std::abs(fb - fa) > 0.5 * (b - a) : std::abs(fa) + std::abs(fb) >= b - a;
  if (decided || halvings == 0) {
    if (differ) {
      roots.push_back(sign_change(along, a, fa, b, fb));
    }
    return;
  }
  const double middle = 0.5 * (a + b);
  const double f = along(middle);
  sign_changes(along, a, fa, middle, f, halvings - 1, roots);
  sign_changes(along, middle, f, b, fb, halvings - 1, roots);
}

// How often a line is halved to find thin parts: in one dimension to 1e-6 of it.
int line_halvings(int dimension) { return dimension == 1 ? 20 : dimension == 2 ? 5 : 3; }

// One sub-box, integrated axis by axis: lengths along the steepest axis, Gauss points along the
// others between the places where the surface crosses the edges of the sub-box (after Saye 2015).
class SubBox {
 public:
  SubBox(const Distance& distance, const Vec3& corner, const Vec3& lower, double side,
         int dimension)
      : distance_(distance), corner_(corner), lower_(lower), side_(side), dimension_(dimension) {
    order_axes();
  }

  MomentSum integrate(int gauss_points) {
    Vec3 at = lower_;
    return over_axis(dimension_ - 1, at, gauss(gauss_points));
  }

 private:
  // order_[0] is the steepest axis, integrated innermost.
  void order_axes() {
    Vec3 slope = Vec3::Zero();
    for (int which = 0; which < 1 << dimension_; ++which) {
      Vec3 at = lower_;
      for (int axis = 0; axis < dimension_; ++axis) {
        at[axis] += (which >> axis & 1) * side_;
      }
      const double value = distance_(at);
      for (int axis = 0; axis < dimension_; ++axis) {
        slope[axis] += (which >> axis & 1) ? value : -value;
      }
    }
    std::stable_sort(order_.begin(), order_.begin() + dimension_,
                     [&](int a, int b) { return std::abs(slope[a]) > std::abs(slope[b]); });
  }

  // Adds the roots, in order; whether the line begins inside.
  bool roots_along(int axis, const Vec3& at, std::vector<double>& roots) const {
    const auto along = [&](double s) {
      Vec3 x = at;
      x[axis] = s;
      return distance_(x);
    };
    const double a = lower_[axis], b = a + side_, fa = along(a);
    sign_changes(along, a, fa, b, along(b), line_halvings(dimension_), roots);
    return fa <= 0.0;
  }

  // Breakpoints along order_[level]: ends, and the roots on the edges of the slice below.
  void find_breaks(int level, Vec3 at) {
    const int axis = order_[static_cast<std::size_t>(level)];
    std::vector<double>& all = breaks_[static_cast<std::size_t>(level)];
    all.assign({lower_[axis], lower_[axis] + side_});
    for (int which = 0; which < 1 << level; ++which) {
      for (int below = 0; below < level; ++below) {
        const int other = order_[static_cast<std::size_t>(below)];
        at[other] = lower_[other] + (which >> below & 1) * side_;
      }
      roots_along(axis, at, all);
    }
    std::sort(all.begin(), all.end());
  }

  MomentSum over_axis(int level, Vec3& at, const Gauss& rule) {
    if (level == 0) {
      return over_line(at);
    }
    const int axis = order_[static_cast<std::size_t>(level)];
    find_breaks(level, at);
    const std::vector<double>& cuts = breaks_[static_cast<std::size_t>(level)];
    MomentSum sum;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const double from = cuts[k], length = cuts[k + 1] - cuts[k];
      for (std::size_t g = 0; length > 0.0 && g < rule.place.size(); ++g) {
        at[axis] = from + rule.place[g] * length;
        sum.add(rule.weight[g] * length, over_axis(level - 1, at, rule));
      }
    }
    return sum;
  }

  // Inside and outside take turns.
  MomentSum over_line(Vec3& at) {
    const int axis = order_[0];
    std::vector<double>& roots = breaks_[0];
    roots.clear();
    bool inside = roots_along(axis, at, roots);
    roots.push_back(lower_[axis] + side_);
    MomentSum sum;
    double from = lower_[axis];
    for (const double to : roots) {
      const double length = to - from;
      if (inside && length > 0.0) {
        at[axis] = from + 0.5 * length;
        sum.add_place(length, at - corner_);
        sum.second(axis, axis) += length * length * length / 12.0;
      }
      inside = !inside;
      from = to;
    }
    return sum;
  }

  const Distance& distance_;
  Vec3 corner_, lower_;
  double side_;
  int dimension_;
  std::array<int, 3> order_{0, 1, 2};
  std::array<std::vector<double>, 3> breaks_;
};

// How finely boxes are halved and which rules are compared.
struct Plan {
  int coarse, fine;  // Gauss points
  double tolerance;  // of the whole box
  int halvings;
};

Plan plan_for(int dimension) {
  return dimension == 1   ? Plan{2, 2, 1.0, 0}
         : dimension == 2 ? Plan{3, 5, 1e-8, 9}
                          : Plan{2, 4, 2e-5, 4};
}

struct Adaptive {
  const Distance& distance;
  Vec3 corner;
  int dimension;
  Plan plan;
  double whole;

  MomentSum integrate(const Vec3& lower, double side, int halvings_left) const {
    Vec3 middle = lower;
    for (int axis = 0; axis < dimension; ++axis) {
      middle[axis] += 0.5 * side;
    }
    const double reach = 0.5 * side * std::sqrt(static_cast<double>(dimension));
    const double depth = distance(middle);
    const double volume = std::pow(side, dimension);
    if (depth >= reach) {
      return {};
    }
    if (depth <= -reach) {
      MomentSum sum = moments_of_box(side, dimension);
      const Vec3 from = lower - corner;
      const Mat3 mixed = sum.first * from.transpose();
      sum.second += mixed + mixed.transpose() + volume * from * from.transpose();
      sum.first += volume * from;
      return sum;
    }
    SubBox box(distance, corner, lower, side, dimension);
    const MomentSum fine = box.integrate(plan.fine);
    if (halvings_left == 0 ||
        std::abs(fine.volume - box.integrate(plan.coarse).volume) <= plan.tolerance * whole) {
      return fine;
    }
    MomentSum sum;
    for (int child = 0; child < 1 << dimension; ++child) {
      Vec3 from = lower;
      for (int axis = 0; axis < dimension; ++axis) {
        from[axis] += (child >> axis & 1) * 0.5 * side;
      }
      sum.add(1.0, integrate(from, 0.5 * side, halvings_left - 1));
    }
    return sum;
  }
};

}  // namespace

MomentSum moments_inside(const Distance& signed_distance, const Vec3& lower, double side,
                         int dimension) {
  const Plan plan = plan_for(dimension);
  const Adaptive adaptive{signed_distance, lower, dimension, plan, std::pow(side, dimension)};
  return adaptive.integrate(lower, side, plan.halvings);
}

}  // namespace lapilli
