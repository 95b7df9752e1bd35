#include "lapilli/scene/initial_state.hpp"

#include <algorithm>
#include <numeric>

#include "lapilli/core/simulation.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/linked_run.hpp"
#include "lapilli/scene/place_errors.hpp"

namespace lapilli {
namespace {

/// Points keep their mass, whatever they are made of.
void require_same_densities(const Scene& scene, const Archive& state,
                            const std::vector<int>& before) {
  if (!state.contains("dynamics/body/density")) {
    return;  // of an earlier version
  }
  const std::vector<double> density = state.read_numbers("dynamics/body/density");
  for (std::size_t body = 0; body < before.size(); ++body) {
    const std::vector<Solid> solids = solids_in(scene.bodies[body]);
    if (before[body] < 0 || solids.empty()) {
      continue;
    }
    const double now = elastic_part(solids.front()).density;
    const double then = density.at(static_cast<std::size_t>(before[body]));
    require_at(now == then, scene, element_path("bodies", body) + ".material", "has a density of ",
               now, " kg/m^3, that of body ", scene.bodies[body].name, " in initial_state is ",
               then, ": bodies that go on keep their mass");
  }
}

}  // namespace

InitialState::InitialState(const Scene& scene) : dimension_(dimension_of(scene)) {
  const LinkedRun run = linked_run(scene);
  state_ = run.state;
  same_transfer_ = run.transfer == name_of(scene.dynamics->transfer);
  require_at(state_->contains("dynamics/velocity"), scene, "initial_state",
             "is of a run without [dynamics]");
  const std::size_t points = state_->read_indices("points/id").size();
  require_at(state_->read_numbers("points/position").size() == points * dimension_, scene,
             "initial_state", "is of a run of another dimension");
  body_before_ = bodies_before(scene, run);
  require_same_densities(scene, *state_, body_before_);
  find_rows();
  std::vector<std::string> known = run.bodies;
  std::erase(known, "");
  require_at(std::any_of(rows_.begin(), rows_.end(), [](const auto& own) { return !own.empty(); }),
             scene, "initial_state", "holds none of the bodies of this scene, but ",
             known.empty() ? "bodies without names" : joined(known));
}

InitialState::InitialState(const StageScene& stage, std::shared_ptr<const Archive> before)
    : state_(std::move(before)),
      dimension_(dimension_of(stage.scene)),
      keeps_ids_(true),
      same_transfer_(stage.same_transfer),
      at_rest_(stage.at_rest),
      body_before_(stage.body_before),
      obstacle_before_(stage.obstacle_before),
      load_before_(stage.load_before),
      same_heat_laws_(stage.same_heat_laws) {
  find_rows();
}

std::vector<std::vector<Index>> InitialState::rows_by_body() const {
  const std::vector<Index> ids = state_->read_indices("points/id");
  const std::vector<Index> bodies = state_->read_indices("points/body");
  std::vector<Index> by_id(ids.size());
  std::iota(by_id.begin(), by_id.end(), Index{0});
  std::ranges::sort(by_id, {}, [&](Index row) { return ids[static_cast<std::size_t>(row)]; });
  std::vector<std::vector<Index>> rows;
  for (const Index row : by_id) {
    const auto body = static_cast<std::size_t>(bodies[static_cast<std::size_t>(row)]);
    rows.resize(std::max(rows.size(), body + 1));
    rows[body].push_back(row);
  }
  return rows;
}

void InitialState::find_rows() {
  const std::vector<std::vector<Index>> there = rows_by_body();
  rows_.resize(body_before_.size());
  for (std::size_t body = 0; body < rows_.size(); ++body) {
    const int before = body_before_[body];
    if (before >= 0 && static_cast<std::size_t>(before) < there.size()) {
      rows_[body] = there[static_cast<std::size_t>(before)];
    }
  }
}

/// Of the points of every body there; empty where the state does not tell.
std::vector<double> InitialState::spacings() const {
  const std::string name = "dynamics/body/spacing";
  return state_->contains(name) ? state_->read_numbers(name) : std::vector<double>();
}

void InitialState::replace(std::vector<FilledPoints>& filled) const {
  const std::vector<double> position = state_->read_numbers("points/position");
  const std::vector<double> volume = state_->read_numbers("points/volume");
  const std::vector<double> spacing = spacings();
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
    if (!spacing.empty()) {
      filled[body].spacing = spacing.at(static_cast<std::size_t>(body_before_[body]));
    }
  }
}

/// Of the points of a body: those they had, or counted on.
std::vector<Index> InitialState::ids_of(std::size_t body,
                                        const std::vector<FilledPoints>& filled) const {
  if (keeps_ids_ && continues(body)) {
    const std::vector<Index> all = state_->read_indices("points/id");
    std::vector<Index> ids;
    for (const Index row : rows_[body]) {
      ids.push_back(all[static_cast<std::size_t>(row)]);
    }
    return ids;
  }
  Index first = keeps_ids_ ? Simulation::created_in(*state_) : 0;
  for (std::size_t before = 0; before < body; ++before) {
    first += keeps_ids_ && continues(before) ? 0 : static_cast<Index>(filled[before].size());
  }
  std::vector<Index> ids(filled[body].size());
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

/// Ids of points that are gone are not given again: there are as many as were ever created.
std::unique_ptr<Points> InitialState::points(const std::vector<FilledPoints>& filled) const {
  auto points = std::make_unique<Points>(dimension_);
  std::vector<Index> ids;
  for (std::size_t body = 0; body < filled.size(); ++body) {
    points->append(filled[body].position, filled[body].volume, static_cast<int>(body));
    const std::vector<Index> own = ids_of(body, filled);
    ids.insert(ids.end(), own.begin(), own.end());
  }
  if (!keeps_ids_) {
    return points;
  }
  Archive present;
  points->save(present);
  present.write("points/id", ids);
  const Index highest = *std::ranges::max_element(ids) + 1;
  const Index created = std::max(highest, Simulation::created_in(*state_));
  const auto gone = static_cast<std::size_t>(created - points->size());
  points->append(std::vector<double>(gone * static_cast<std::size_t>(dimension_)),
                 std::vector<double>(gone), 0);
  points->load(present);
  return points;
}

PointStart InitialState::start(const std::vector<FilledPoints>& filled) const {
  PointStart start;
  start.state = state_;
  start.same_transfer = same_transfer_;
  start.at_rest = at_rest_;
  start.obstacle = obstacle_before_;
  start.load = load_before_;
  start.same_heat_laws = same_heat_laws_;
  for (std::size_t body = 0; body < filled.size(); ++body) {
    start.body.push_back(continues(body) ? body_before_[body] : -1);
    const std::vector<Index> ids = ids_of(body, filled);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const auto id = static_cast<std::size_t>(ids[k]);
      start.row.resize(std::max(start.row.size(), id + 1), -1);
      start.row[id] = continues(body) ? rows_[body][k] : -1;
    }
  }
  return start;
}

}  // namespace lapilli
