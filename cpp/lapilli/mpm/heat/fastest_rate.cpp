#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "lapilli/geometry/random.hpp"
#include "lapilli/mpm/heat/weak_exchange.hpp"

namespace lapilli {

double fastest_rate(std::span<const double> capacity,
                    const std::function<void(std::span<double>, std::span<double>)>& apply) {
  constexpr int steps = 30;
  constexpr double margin = 1.02;
  const auto size = static_cast<Index>(capacity.size());
  std::vector<double> scaling(capacity.size(), 0.0), full(capacity.size()),
      product(capacity.size());
  Eigen::VectorXd now(size), before = Eigen::VectorXd::Zero(size), image(size);
  Random random(7);
  for (Index place = 0; place < size; ++place) {
    const double noise = random.uniform(-1.0, 1.0);
    scaling[place] = capacity[place] > 0.0 ? 1.0 / std::sqrt(capacity[place]) : 0.0;
    now[place] = capacity[place] > 0.0 ? noise : 0.0;
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
    apply(full, product);
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

template <int Dim>
double fastest_rate(const HeatPart<Dim>& part, const std::vector<WeakExchange>& weak) {
  return fastest_rate(part.capacity, [&](std::span<double> x, std::span<double> y) {
    part.followers.prolong(x);
    std::fill(y.begin(), y.end(), 0.0);
    part.conduction->multiply(x.data(), [&](Index place, const auto& some) {
      std::copy(some.begin(), some.end(), y.begin() + place);
    });
    for (const WeakExchange& law : weak) {
      for (std::size_t k = 0; k < law.place.size(); ++k) {
        y[law.place[k]] += law.coefficient * law.area[k] * x[law.place[k]];
      }
    }
    part.followers.restrict_to_leaders(y);
  });
}

template double fastest_rate(const HeatPart<1>&, const std::vector<WeakExchange>&);
template double fastest_rate(const HeatPart<2>&, const std::vector<WeakExchange>&);
template double fastest_rate(const HeatPart<3>&, const std::vector<WeakExchange>&);

}  // namespace lapilli
