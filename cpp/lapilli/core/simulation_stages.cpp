// How one stage of a run follows another.
#include <unordered_set>

#include "lapilli/core/diagnostics.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/simulation.hpp"
#include "lapilli/core/stores_in_points.hpp"

namespace lapilli {
namespace {

constexpr const char* start_prefix = "stage/start/";

std::vector<Index> rows_not_in(const Points& points, const Points& others) {
  const std::unordered_set<Index> known(others.id().begin(), others.id().end());
  std::vector<Index> rows;
  for (Index row = 0; row < points.size(); ++row) {
    if (!known.contains(points.id()[static_cast<std::size_t>(row)])) {
      rows.push_back(row);
    }
  }
  return rows;
}

/// What points store of a balance; 0 where the physics does not know it.
double stored(const Physics& physics, std::span<const Index> rows, std::size_t balance) {
  const auto* known = dynamic_cast<const StoresInPoints*>(&physics);
  return known == nullptr ? 0.0 : known->stored_in(rows).at(balance);
}

/// Book what the end of a stage and the begin of the next one, `after`, mean for the run.
void book(const Simulation& before, const Simulation::Stage::Parts& after, const std::string& name,
          StageAccount& account) {
  const std::vector<Index> gone = rows_not_in(before.points(), *after.points);
  const std::vector<Index> added = rows_not_in(*after.points, before.points());
  for (std::size_t k = 0; k < before.physics().size(); ++k) {
    const Physics& old = *before.physics()[k];
    const Physics& fresh = *after.physics[k];
    const std::vector<Balance> had = old.balances(), has = fresh.balances();
    for (std::size_t b = 0; b < had.size(); ++b) {
      StageAccount::Change change{stored(old, gone, b), stored(fresh, added, b), 0.0};
      change.left = has[b].stored - had[b].stored + change.removed - change.added;
      account.close(had[b], name, change);
    }
    for (const auto& [words, value] : old.diagnostics()) {
      if (counts_what_happened(words)) {
        account.close(old.name() + "/" + words, value);
      }
    }
  }
}

}  // namespace

Index Simulation::created_in(const Archive& state) { return state.read_index("stage/created"); }

std::vector<double> Simulation::stage_ends() const {
  std::vector<double> ends;
  for (const Stage& stage : stages_) {
    ends.push_back(stage.clock.start);
  }
  return ends;
}

void Simulation::save_state(Archive& archive) const {
  points_->save(archive);
  for (const auto& physics : physics_) {
    physics->save(archive);
  }
  if (!stages_.empty()) {
    archive.write("stage/created", points_->created());
  }
}

void Simulation::begin_next_stage() {
  auto before = std::make_shared<Archive>();
  save_state(*before);
  Stage::Parts parts = next_parts(before);
  watch_balances();
  book(*this, parts, stages_[stage_].name, account_);
  replace_parts(std::move(parts), before);
  watch_balances();
}

/// Mistakes that depend on the state are no longer those of the scene alone.
Simulation::Stage::Parts Simulation::next_parts(
    const std::shared_ptr<const Archive>& before) const {
  const Stage& next = stages_[stage_];
  try {
    Stage::Parts parts = next.begin(before);
    const auto names = [](const auto& list) {
      std::string all;
      for (const auto& physics : list) {
        all += physics->name() + " ";
      }
      return all;
    };
    require(names(parts.physics) == names(physics_), "it has other physics than the stage before");
    return parts;
  } catch (const std::invalid_argument& error) {
    throw RunError(
        message("time ", time_, " s: stage '", next.name, "' cannot begin: ", error.what()));
  }
}

void Simulation::replace_parts(Stage::Parts parts, std::shared_ptr<const Archive> before) {
  physics_ = std::move(parts.physics);  // the old ones detach their arrays from the old points
  points_ = std::move(parts.points);
  body_numbers_ = std::move(parts.body_numbers);
  clock_ = stages_[stage_].clock;
  stage_start_ = std::move(before);
  ++stage_;
}

/// A stage is made from the state before it, and goes on from its own: both are needed to resume.
void Simulation::save_stage(Archive& archive) const {
  archive.write("stage/index", static_cast<Index>(stage_));
  archive.write("stage/bodies", body_numbers_);
  account_.save(archive);
  if (stage_start_) {
    for (const auto& [name, array] : stage_start_->arrays()) {
      archive.insert(start_prefix + name, array);
    }
  }
}

void Simulation::load_stage(const Archive& archive) {
  const auto stage = static_cast<std::size_t>(archive.read_index("stage/index"));
  require(stage_ == 0 && stage <= stages_.size(), "a run is resumed from its first stage");
  account_.load(archive);
  if (stage == 0) {
    return;
  }
  auto before = std::make_shared<Archive>();
  const std::string prefix = start_prefix;
  for (const auto& [name, array] : archive.arrays()) {
    if (name.starts_with(prefix)) {
      before->insert(name.substr(prefix.size()), array);
    }
  }
  stage_ = stage - 1;
  replace_parts(next_parts(before), before);
}

}  // namespace lapilli
