#include "lapilli/mpm/heat/cut_bodies.hpp"

#include <algorithm>
#include <iterator>

#include "lapilli/mpm/heat/drawn_gaps.hpp"
#include "lapilli/mpm/heat/strong_ends.hpp"
#include "lapilli/mpm/surface/divide_pieces.hpp"

namespace lapilli {

std::vector<std::string> names_of(const std::vector<HeatBody>& bodies) {
  std::vector<std::string> names;
  for (const HeatBody& body : bodies) {
    names.push_back(body.name);
  }
  return names_or_numbers(std::move(names));
}

PairEntries resisting_pairs(const std::vector<HeatBody>& bodies,
                            const std::vector<HeatContact>& contacts) {
  std::vector<std::vector<std::string>> pairs;
  for (const HeatContact& contact : contacts) {
    pairs.push_back(contact.bodies);
  }
  return PairEntries("heat.contacts", pairs, names_of(bodies));
}

template <int Dim>
HeatProblem<Dim> with_kinks(HeatProblem<Dim> problem) {
  const auto kinks = [&](const HeatBody& body) {
    return body.material.melts() ||
           body.material.conductivity != problem.bodies.front().material.conductivity;
  };
  if (problem.shape == ShapeFunction::gimp &&
      std::any_of(problem.bodies.begin(), problem.bodies.end(), kinks)) {
    problem.shape = ShapeFunction::linear;
  }
  return problem;
}

template <int Dim>
CutBody<Dim> cut_body(const HeatProblem<Dim>& problem, std::span<const Shape> shapes,
                      std::size_t body, const PairEntries& resisting, SurfaceFound& found) {
  using Division = SurfaceDivision<Dim>;
  constexpr double along_axis = 1.0 - 1e-6;
  std::vector<double> conductivity;
  for (const HeatBody& one : problem.bodies) {
    conductivity.push_back(largest_conductivity(one.material));
  }
  CutBody<Dim> made;
  made.cells = cut_shape<Dim>(shapes[body], problem.grid, CubeLayout(problem.shape));
  const std::vector<const Shape*> regions = regions_of(problem.settings.boundaries);
  Division division(problem.grid, shapes, body, regions, problem.walls);
  StrongEnds<Dim> ends(problem, body, division);
  for (const CellCut<Dim>& cell : made.cells) {
    const Index at = problem.grid.node_index(cell.node);
    for (const SurfacePiece<Dim>& piece : cell.pieces) {
      division.divide(piece, [&](int law, const SurfacePiece<Dim>& part) {
        if (law >= 0) {
          ends.add(law, part);
        } else if (law < Division::on_wall_label &&
                   resisting.of(body, Division::body_of(law)) >= 0) {
          made.resisting[Division::body_of(law)].push_back(part);
        } else if (law < Division::on_wall_label) {
          Mat<Dim>& sum = made.interface.try_emplace(at, Mat<Dim>::Zero()).first->second;
          sum += part.area() * part.normal * part.normal.transpose();
          const double better = conductivity[Division::body_of(law)] / conductivity[body];
          if (better > 1.0) {
            found.better = std::max(found.better, better);
            found.slanted += part.normal.cwiseAbs().maxCoeff() < along_axis ? part.area() : 0.0;
          }
        }
        if (law >= Division::nobody) {
          found.area += part.area();
          enter_facing<Dim>(part, shapes, body, problem.grid.cell_size(), found);
        }
      });
    }
  }
  made.pieces = ends.pieces(found);
  enter_touching(division.touching(), found);
  std::copy_if(division.touching().begin(), division.touching().end(),
               std::back_inserter(made.touching),
               [&](std::size_t other) { return resisting.of(body, other) < 0; });
  return made;
}

template HeatProblem<1> with_kinks(HeatProblem<1>);
template HeatProblem<2> with_kinks(HeatProblem<2>);
template HeatProblem<3> with_kinks(HeatProblem<3>);
template CutBody<1> cut_body(const HeatProblem<1>&, std::span<const Shape>, std::size_t,
                             const PairEntries&, SurfaceFound&);
template CutBody<2> cut_body(const HeatProblem<2>&, std::span<const Shape>, std::size_t,
                             const PairEntries&, SurfaceFound&);
template CutBody<3> cut_body(const HeatProblem<3>&, std::span<const Shape>, std::size_t,
                             const PairEntries&, SurfaceFound&);

}  // namespace lapilli
