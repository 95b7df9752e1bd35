#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/diagnostics.hpp"
#include "lapilli/core/probes.hpp"
#include "lapilli/output/run_options.hpp"

namespace lapilli {

/// Scalars in time: one row for each moment, one column for each scalar.
class History {
 public:
  /// Append a row; `keep` whether a resumed run starts with it. Columns that are new are NaN so
  /// far, those that the row does not have are NaN in it: stages of a run may differ in both.
  void add(double time, std::vector<Scalar> scalars, bool keep);
  bool has_row_at(double time) const { return rows() > 0 && at(rows() - 1, 0) == time; }
  /// The last row is one of those that a resumed run starts with.
  void keep_last() { kept_ = rows(); }

  /// Name, unit and meaning of every column after the time.
  const std::vector<Scalar>& columns() const { return columns_; }
  Index rows() const { return static_cast<Index>(numbers_.size() / (columns_.size() + 1)); }
  /// Number `column` of a row; column 0 is the time, s.
  double at(Index row, std::size_t column) const {
    return numbers_[static_cast<std::size_t>(row) * (columns_.size() + 1) + column];
  }
  /// Lines of numbers with commas between, names in the first; empty where there is no number.
  std::string to_csv() const;

  /// `with_units`: so that columns of earlier stages are known when the run is resumed.
  void save(Archive& archive, bool with_units) const;
  /// Columns that this run does not have are left out, new ones are NaN so far.
  void load(const Archive& archive, std::vector<Scalar> columns);

 private:
  std::vector<Scalar> aligned(std::vector<Scalar> scalars);
  void widen(std::size_t columns);

  std::vector<Scalar> columns_;
  std::vector<double> numbers_;
  Index kept_ = 0;
};

/// Decides when a row of the history is due and what it holds.
class HistoryRecorder {
 public:
  /// Chooses the material points of probes in the present state: the start.
  HistoryRecorder(Simulation& simulation, const RunOptions& options);

  /// A row of now, unless there is one.
  void add(bool keep);
  /// A row of now if one is due after this step. Rows never change the steps: they come with the
  /// first step that ends at a multiple of an interval or after it.
  void after_step();

  const History& history() const { return history_; }
  void save(Archive& archive) const { history_.save(archive, !simulation_.later_stages().empty()); }
  /// The history of a checkpoint whose state the simulation is in.
  void load(const Archive& archive);

 private:
  struct Schedule {
    double interval = 0.0;  // s, or
    Index steps = 0;
  };
  std::vector<Scalar> observe() const;
  bool is_due() const;

  Simulation& simulation_;
  int bodies_;
  Probes probes_;
  std::vector<Schedule> schedules_;
  double last_time_;  // s, of the step before
  History history_;
};

}  // namespace lapilli
