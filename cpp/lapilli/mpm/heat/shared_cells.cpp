#include "lapilli/mpm/heat/shared_cells.hpp"

#include <algorithm>

#include "lapilli/core/symmetric_modes.hpp"

namespace lapilli {

template <int Dim>
SharedCells<Dim>::SharedCells(const HeatProblem<Dim>& problem,
                              const std::vector<std::size_t>& bodies,
                              const std::vector<std::map<Index, double>>& volumes,
                              const std::vector<CutBody<Dim>>& cut)
    : problem_(problem), bodies_(bodies) {
  const bool alike = std::all_of(bodies.begin(), bodies.end(), [&](std::size_t body) {
    return problem.bodies[body].material.conductivity ==
           problem.bodies[bodies.front()].material.conductivity;
  });
  if (alike) {
    return;
  }
  for (std::size_t which = 0; which < bodies.size(); ++which) {
    for (const auto& [node, volume] : volumes[which]) {
      if (volume > 0.0) {
        parts_[node].push_back({which, volume});
      }
    }
    for (const auto& [node, sum] : cut[bodies[which]].interface) {
      interface_.try_emplace(node, Mat<Dim>::Zero()).first->second += sum;
    }
  }
  std::erase_if(parts_, [](const auto& cell) { return cell.second.size() < 2; });
  for (auto& [node, parts] : parts_) {
    double sum = 0.0;
    for (const Part& part : parts) {
      sum += part.fraction;
    }
    for (Part& part : parts) {
      part.fraction /= sum;
    }
  }
}

template <int Dim>
Mat<Dim> SharedCells<Dim>::own(std::size_t which) const {
  return problem_.bodies[bodies_[which]].material.conductivity.largest().template block<Dim>();
}

// Where surfaces end, the body's nearest face at the middle of the cell may be another one.
template <int Dim>
Vec<Dim> SharedCells<Dim>::normal(std::size_t which, Index node, const Vec<Dim>& center) const {
  if (const auto found = interface_.find(node); found != interface_.end()) {
    return symmetric_modes<Dim>(found->second).eigenvectors.col(Dim - 1);
  }
  Vec3 at = Vec3::Zero();
  at.head<Dim>() = center;
  const Vec3 outward = gradient(*problem_.bodies[bodies_[which]].shape, at);
  return outward.head<Dim>().normalized();
}

// With the mean slope G the slope in body b is G + n (q - n . K_b G)/(n . K_b n), where q, the flux
// across the interface, makes the slopes average to G; it is none where a body does not conduct
// that way.
template <int Dim>
Mat<Dim> SharedCells<Dim>::conductivity(std::size_t which, Index node,
                                        const Vec<Dim>& center) const {
  const Vec<Dim> normal = this->normal(which, node, center);
  double resistance = 0.0;
  bool conducts = true;
  Vec<Dim> across = Vec<Dim>::Zero();
  for (const Part& part : parts_.at(node)) {
    const Vec<Dim> flux = own(part.which) * normal;
    const double through = normal.dot(flux);
    conducts = conducts && through > 0.0;
    resistance += part.fraction / through;
    across += part.fraction / through * flux;
  }
  const Mat<Dim> k = own(which);
  const Vec<Dim> flux = k * normal;
  if (!(normal.dot(flux) > 0.0)) {
    return k;
  }
  const Vec<Dim> wanted = conducts ? Vec<Dim>(across / resistance) : Vec<Dim>::Zero();
  const Mat<Dim> slope =
      Mat<Dim>::Identity() + normal * (wanted - flux).transpose() / normal.dot(flux);
  return slope.transpose() * k * slope;
}

template class SharedCells<1>;
template class SharedCells<2>;
template class SharedCells<3>;

}  // namespace lapilli
