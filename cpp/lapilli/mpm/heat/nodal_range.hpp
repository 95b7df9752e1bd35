#pragma once

#include <functional>

#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"

namespace lapilli {

/// What nodes hold, by place: the heat that would bring one to a temperature, and a way to give it
/// some, J.
struct NodalStore {
  std::function<double(Index place, double temperature)> needed;
  std::function<void(Index place, double heat)> give;
};

/// Keeps the nodes inside the bodies of a part to the temperatures that conduction and exchange can
/// reach. What a step puts beyond them is handed to the neighbours, nearest first, in proportion to
/// what these can take up: heat stays, and nodes within the range are met by none but such heat
/// (repair by redistribution, Kucharik, Shashkov & Wendroff 2003). Nodes outside of the bodies go
/// on in a straight line from those inside and are not bounded.
template <int Dim>
class NodalRange {
 public:
  NodalRange() = default;
  NodalRange(const HeatProblem<Dim>& problem, const HeatPart<Dim>& part);

  /// Widen a range to what these nodes have now.
  void include(std::span<const double> temperature, TemperatureRange& range) const;
  /// How far they are beyond a range, K.
  double stray(std::span<const double> temperature, const TemperatureRange& range) const;
  /// Bring them back into it; returns whether any had strayed.
  bool restore(const HeatPart<Dim>& part, const TemperatureRange& range,
               std::span<double> temperature) const;
  /// The same where heat is not capacity times temperature: `store` changes `temperature` as well.
  bool restore(const HeatPart<Dim>& part, const TemperatureRange& range,
               std::span<const double> temperature, const NodalStore& store) const;

 private:
  struct Run {
    Index place, count, node;  // the first, how many, and the first in the grid
  };
  void restore_node(const HeatPart<Dim>& part, Index node, double bound,
                    const NodalStore& store) const;
  TemperatureRange extent(std::span<const double> temperature) const;

  std::optional<Grid<Dim>> grid_;
  std::vector<Run> runs_;
  std::vector<unsigned char> inside_;  // by node of the grid
};

}  // namespace lapilli
