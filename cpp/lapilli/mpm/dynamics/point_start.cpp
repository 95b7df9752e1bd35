#include "lapilli/mpm/dynamics/point_start.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
void PointStart::apply(DynamicsData<Dim>& data) const {
  const auto fetch = [&](const std::string& name, PointArray& into) {
    const std::vector<double> from = state->read_numbers(name);
    const auto width = static_cast<Index>(into.components());
    for (Index here = 0; here < data.points.size(); ++here) {
      const Index there = row[data.points.id()[here]];
      if (there >= 0) {
        require((there + 1) * width <= static_cast<Index>(from.size()),
                "the state to start from "
                "holds ",
                name, " of another dimension");
        std::copy_n(from.begin() + there * width, width, into.data() + here * width);
      }
    }
  };
  require(state->contains("dynamics/velocity"),
          "the state to start from is of a run without [dynamics]");
  fetch("dynamics/mass", data.mass);
  fetch("dynamics/velocity", data.velocity);
  fetch("dynamics/stress", data.stress);
  if (data.affine && same_transfer && state->contains("dynamics/affine")) {
    fetch("dynamics/affine", *data.affine);
    fetch("dynamics/carried", *data.carried);
  } else if (data.carried) {
    fetch("dynamics/velocity", *data.carried);
  }
  if (data.opened && state->contains("dynamics/opened")) {
    fetch("dynamics/opened", *data.opened);
  }
  if (data.strain_rate && state->contains("dynamics/strain_rate")) {
    fetch("dynamics/strain_rate", *data.strain_rate);
  }
  for (const auto& [name, values] : data.states.arrays()) {
    if (state->contains("dynamics/state/" + name)) {
      fetch("dynamics/state/" + name, *values);
    }
  }
}

template void PointStart::apply<2>(DynamicsData<2>&) const;
template void PointStart::apply<3>(DynamicsData<3>&) const;

}  // namespace lapilli
