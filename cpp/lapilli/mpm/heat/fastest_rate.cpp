#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "lapilli/geometry/random.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"

namespace lapilli {

template <int Dim>
double fastest_rate(const HeatPart<Dim>& part) {
  constexpr int steps = 30;
  constexpr double margin = 1.02;
  const auto size = static_cast<Index>(part.capacity.size());
  std::vector<double> scaling(part.capacity.size(), 0.0), full(part.capacity.size());
  Eigen::VectorXd now(size), before = Eigen::VectorXd::Zero(size), image(size);
  Random random(7);
  for (Index place = 0; place < size; ++place) {
    const double noise = random.uniform(-1.0, 1.0);
    scaling[place] = part.capacity[place] > 0.0 ? 1.0 / std::sqrt(part.capacity[place]) : 0.0;
    now[place] = part.capacity[place] > 0.0 ? noise : 0.0;
  }
  if (!(now.norm() > 0.0)) {
    return 0.0;
  }
  now.normalize();
  std::vector<double> diagonal, beside;
  for (int step = 0; step < std::min<Index>(steps, size); ++step) {
    for (Index place = 0; place < size; ++place) {
      full[place] = scaling[place] * now[place];
    }
    part.followers.prolong(full);
    std::vector<double> product(full.size(), 0.0);
    part.conduction->multiply(full.data(), [&](Index place, int count, const auto& some) {
      std::copy_n(some.begin(), count, product.begin() + place);
    });
    part.followers.restrict_to_leaders(product);
    for (Index place = 0; place < size; ++place) {
      image[place] = scaling[place] * product[place];
    }
    diagonal.push_back(now.dot(image));
    image -= diagonal.back() * now + (beside.empty() ? 0.0 : beside.back()) * before;
    const double length = image.norm();
    if (!(length > 1e-12 * std::abs(diagonal.front()))) {
      break;
    }
    beside.push_back(length);
    before = now;
    now = image / length;
  }
  const auto count = static_cast<Eigen::Index>(diagonal.size());
  beside.resize(diagonal.size(), 0.0);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz;
  ritz.computeFromTridiagonal(Eigen::Map<Eigen::VectorXd>(diagonal.data(), count),
                              Eigen::Map<Eigen::VectorXd>(beside.data(), count - 1),
                              Eigen::EigenvaluesOnly);
  return margin * std::max(0.0, ritz.eigenvalues().maxCoeff());
}

template double fastest_rate(const HeatPart<1>&);
template double fastest_rate(const HeatPart<2>&);
template double fastest_rate(const HeatPart<3>&);

}  // namespace lapilli
