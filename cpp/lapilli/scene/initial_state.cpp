#include "lapilli/scene/initial_state.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <sstream>

#include "lapilli/output/checkpoint.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/place_errors.hpp"

namespace lapilli {
namespace {

/// The settings that a checkpoint tells of its scene.
std::map<std::string, std::string> settings_in(const std::string& identity) {
  std::map<std::string, std::string> settings;
  std::istringstream lines(identity);
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t tab = line.find('\t'); tab != std::string::npos) {
      settings[line.substr(0, tab)] = line.substr(tab + 1);
    }
  }
  return settings;
}

}  // namespace

InitialState::InitialState(const Scene& scene)
    : dimension_(dimension_of(scene)), rows_(scene.bodies.size()) {
  const std::string& name = scene.initial_state;
  require_at(!name.ends_with(".vtkhdf"), scene, "initial_state",
             "names frames; the state is in the checkpoint beside them: ",
             name.substr(0, name.size() - std::string(".vtkhdf").size()), ".checkpoint");
  Checkpoint checkpoint =
      in_file(scene, "initial_state", [&] { return load_checkpoint(scene.initial_state); });
  state_ = std::make_shared<const Archive>(std::move(checkpoint.state));
  const auto settings = settings_in(checkpoint.identity);
  const auto transfer = settings.find("dynamics.transfer");
  same_transfer_ =
      transfer != settings.end() && transfer->second == name_of(scene.dynamics->transfer);

  const std::vector<Index> ids = state_->read_indices("points/id");
  const std::vector<Index> bodies = state_->read_indices("points/body");
  std::vector<Index> by_id(ids.size());
  std::iota(by_id.begin(), by_id.end(), Index{0});
  std::ranges::sort(by_id, {}, [&](Index row) { return ids[static_cast<std::size_t>(row)]; });
  require_at(state_->read_numbers("points/position").size() == ids.size() * dimension_, scene,
             "initial_state", "is of a run of another dimension");
  std::string known;
  for (Index number = 0;; ++number) {
    const auto found = settings.find(message("bodies.", number, ".name"));
    if (found == settings.end()) {
      break;
    }
    known += (known.empty() ? "" : ", ") + found->second;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
      if (scene.bodies[body].name.empty() || scene.bodies[body].name != found->second) {
        continue;
      }
      for (const Index row : by_id) {
        if (bodies[row] == number) {
          rows_[body].push_back(row);
        }
      }
    }
  }
  require_at(std::any_of(rows_.begin(), rows_.end(), [](const auto& own) { return !own.empty(); }),
             scene, "initial_state", "holds none of the bodies of this scene, but ",
             known.empty() ? "bodies without names" : known);
}

void InitialState::replace(std::vector<FilledPoints>& filled) const {
  const std::vector<double> position = state_->read_numbers("points/position");
  const std::vector<double> volume = state_->read_numbers("points/volume");
  for (std::size_t body = 0; body < filled.size(); ++body) {
    if (!continues(body)) {
      continue;
    }
    filled[body].position.clear();
    filled[body].volume.clear();
    for (const Index row : rows_[body]) {
      const auto begin = position.begin() + row * dimension_;
      filled[body].position.insert(filled[body].position.end(), begin, begin + dimension_);
      filled[body].volume.push_back(volume[row]);
    }
  }
}

std::shared_ptr<const PointStart> InitialState::points(
    const std::vector<FilledPoints>& filled) const {
  auto start = std::make_shared<PointStart>();
  start->state = state_;
  start->same_transfer = same_transfer_;
  for (std::size_t body = 0; body < filled.size(); ++body) {
    if (continues(body)) {
      start->row.insert(start->row.end(), rows_[body].begin(), rows_[body].end());
    } else {
      start->row.insert(start->row.end(), filled[body].size(), -1);
    }
  }
  return start;
}

}  // namespace lapilli
