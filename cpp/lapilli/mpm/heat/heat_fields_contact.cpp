// Heat between bodies that touch.
#include <algorithm>
#include <set>

#include "lapilli/core/pair_entries.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/heat/heat_fields.hpp"

namespace lapilli {
namespace {

/// Numbers for bodies of one name: columns of the history are told by them.
template <int Dim>
std::vector<std::string> distinct_names_of(const HeatProblem<Dim>& problem) {
  std::vector<std::string> names;
  for (const HeatBody& body : problem.bodies) {
    const auto same = std::ranges::count(problem.bodies, body.name, &HeatBody::name);
    names.push_back(same > 1 ? std::string() : body.name);
  }
  return names_or_numbers(std::move(names));
}

}  // namespace

template <int Dim>
void HeatFields<Dim>::find_pairs(const HeatProblem<Dim>& problem) {
  const std::vector<HeatContact>& contacts = problem.settings.contacts;
  const std::vector<std::string> names = distinct_names_of(problem);
  const PairEntries entries = resisting_pairs(problem.bodies, contacts);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    require(!contacts[k].conductance.is_function(), "heat.contacts.", k,
            ".conductance must be a number or a table in time where bodies move");
  }
  std::vector<int> used;
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = a + 1; b < names.size(); ++b) {
      const int first = fields_.index_of(static_cast<Index>(a));
      const int second = fields_.index_of(static_cast<Index>(b));
      const int own = entries.own(a, b);
      require(own < 0 || first != second, "heat.contacts.", own, ": ", names[a], " and ", names[b],
              " are bonded and share their temperatures; say dynamics.contacts.contact = "
              "\"frictional\" for them");
      if (first == second) {
        continue;
      }
      const int low = std::min(first, second), high = std::max(first, second);
      auto pair = std::ranges::find_if(
          pairs_, [&](const Pair& one) { return one.first == low && one.second == high; });
      const int entry = entries.of(a, b);
      if (pair == pairs_.end()) {
        pairs_.push_back({low, high, {}, message("heat from ", names[a], " to ", names[b]), 0.0});
        used.push_back(-1);
        pair = pairs_.end() - 1;
      }
      int& known = used[static_cast<std::size_t>(pair - pairs_.begin())];
      require(own < 0 || known < 0 || known == own || entries.own(a, b) < 0, "heat.contacts.", own,
              " and .", known, " are about bodies that are bonded to each other");
      if (entry >= 0 && (own >= 0 || known < 0)) {
        known = entry;
        pair->conductance = contacts[static_cast<std::size_t>(entry)].conductance;
      }
    }
  }
}

/// Nodes beside those that touch which one of the fields just reaches: left to conduction, which
/// ends there, they would flatten the gradients of its points. What they have goes to the one that
/// touches.
template <int Dim>
void HeatFields<Dim>::hold_outer_nodes(const std::vector<BodyTouch>& touches) {
  constexpr int block = Dim == 1 ? 3 : Dim == 2 ? 9 : 27;
  constexpr double light = 1e-3;  // of the other field's capacity
  std::set<std::pair<Index, std::pair<int, int>>> known;
  for (const BodyTouch& touch : touches) {
    known.insert({touch.node, {touch.first, touch.second}});
  }
  for (const BodyTouch& touch : touches) {
    for (int b = 0; b < block; ++b) {
      Index node = touch.node;
      for (int axis = 0, rest = b; axis < Dim; ++axis, rest /= 3) {
        node += (rest % 3 - 1) * grid_.node_stride(axis);
      }
      if (known.contains({node, {touch.first, touch.second}})) {
        continue;
      }
      const Index one = fields_.node_in(touch.first, node);
      const Index two = fields_.node_in(touch.second, node);
      if (one < 0 || two < 0 || !(nodes_.capacity[one] > 0.0) || !(nodes_.capacity[two] > 0.0)) {
        continue;
      }
      const bool first_is_light = nodes_.capacity[one] < light * nodes_.capacity[two];
      if (!first_is_light && !(nodes_.capacity[two] < light * nodes_.capacity[one])) {
        continue;
      }
      const Index outer = first_is_light ? one : two;
      const Index heir = fields_.node_in(first_is_light ? touch.first : touch.second, touch.node);
      if (heir >= 0 && nodes_.capacity[heir] > 0.0) {
        nodes_.hand_on(outer, heir);
      }
    }
  }
}

template <int Dim>
std::size_t HeatFields<Dim>::pair_of(const BodyTouch& touch) const {
  const auto found = std::ranges::find_if(pairs_, [&](const Pair& one) {
    return one.first == touch.first && one.second == touch.second;
  });
  return static_cast<std::size_t>(found - pairs_.begin());
}

/// One temperature at a node, but for a contact conductance. Taken at the end of the step, pair by
/// pair: no conductance carries one past the other.
template <int Dim>
void HeatFields<Dim>::exchange_level(const BodyTouch& touch, const Step& step) {
  Pair& pair = pairs_[pair_of(touch)];
  const Index a = fields_.node_in(touch.first, touch.node);
  const Index b = fields_.node_in(touch.second, touch.node);
  double resistance = 1.0 / nodes_.capacity[a] + 1.0 / nodes_.capacity[b];
  if (const auto& given = pair.conductance) {
    const double passes = given->mean(step.time, step.time + step.size) * touch.area * step.size;
    if (!(passes > 0.0)) {
      return;
    }
    resistance += 1.0 / passes;
  }
  const double apart =
      nodes_.temperature[a] + nodes_.increment[a] - (nodes_.temperature[b] + nodes_.increment[b]);
  const double heat = apart / resistance;
  nodes_.increment[a] -= heat / nodes_.capacity[a];
  nodes_.increment[b] += heat / nodes_.capacity[b];
  pair.heat += heat;
}

template <int Dim>
void HeatFields<Dim>::exchange(const Step& step) {
  hold_outer_nodes(touches_());
  hand_to_leaders(step);
  for (const BodyTouch* touch : level_) {
    exchange_level(*touch, step);
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                  \
  template void HeatFields<Dim>::find_pairs(const HeatProblem<Dim>&);             \
  template void HeatFields<Dim>::hold_outer_nodes(const std::vector<BodyTouch>&); \
  template void HeatFields<Dim>::exchange_level(const BodyTouch&, const Step&);   \
  template std::size_t HeatFields<Dim>::pair_of(const BodyTouch&) const;          \
  template void HeatFields<Dim>::exchange(const Step&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
