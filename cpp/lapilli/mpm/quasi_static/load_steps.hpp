#pragma once

#include <limits>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/mpm/quasi_static/settings.hpp"

namespace lapilli {

/// Where load steps end: with the steps of the clock, and before that at every entry of a table of
/// loads or displacements, whose peaks would be lost between two ends. At a jump one ends before it
/// and one after. A step that was cut short is followed by one to where it would have ended.
class LoadSteps {
 public:
  /// `settings` must outlive it.
  explicit LoadSteps(const QuasiStaticSettings& settings);

  /// End of a step from `time` of which the clock asks for `size`, s.
  double end(double time, double size) const;
  /// Such a step was taken, or the first part of it.
  void took(double time, double size) { whole_ = whole(time, size); }

  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  double whole(double time, double size) const;

  std::vector<const Value*> laws_;
  double whole_ = -std::numeric_limits<double>::infinity();  // s, end of the last step uncut
};

/// The length of a step from `time` to `end` which, added to `time`, is not before `end`, s.
double length_to(double end, double time);

}  // namespace lapilli
