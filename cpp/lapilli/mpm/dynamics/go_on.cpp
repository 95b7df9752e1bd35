#include "lapilli/mpm/dynamics/go_on.hpp"

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
void go_on(const PointStart& start, DynamicsData<Dim>& data) {
  const Archive& state = *start.state;
  const auto fetch = [&](const std::string& name, PointArray& into) {
    start.fetch(name, data.points, into);
  };
  const auto fetch_known = [&](const std::string& name, PointArray& into) {
    if (state.contains(name)) {
      fetch(name, into);
    }
  };
  require(state.contains("dynamics/velocity"),
          "the state to start from is of a run without [dynamics]");
  fetch("dynamics/mass", data.mass);
  fetch("dynamics/stress", data.stress);
  if (!start.at_rest) {
    fetch("dynamics/velocity", data.velocity);
    if (data.affine && start.same_transfer && state.contains("dynamics/affine")) {
      fetch("dynamics/affine", *data.affine);
      fetch("dynamics/carried", *data.carried);
    } else if (data.carried) {
      fetch("dynamics/velocity", *data.carried);
    }
    if (data.strain_rate) {
      fetch_known("dynamics/strain_rate", *data.strain_rate);
    }
  }
  if (data.opened) {
    fetch_known("dynamics/opened", *data.opened);
  }
  for (const auto& [name, values] : data.states.arrays()) {
    fetch_known("dynamics/state/" + name, *values);
  }
}

template void go_on<2>(const PointStart&, DynamicsData<2>&);
template void go_on<3>(const PointStart&, DynamicsData<3>&);

}  // namespace lapilli
