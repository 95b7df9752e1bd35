#pragma once

namespace lapilli {

/// Notices a run whose motion gains energy that nobody put in: an unstable step, transfer or layout
/// of points shows here long before it shows in the fields.
///
/// Watched is kinetic energy plus work on the strain of the points (elastic or not, so that the law
/// of the material does not matter) less the work of gravity and loads.
class EnergyWatch {
 public:
  /// `stored`: elastic energy at the start, J.
  explicit EnergyWatch(double stored = 0.0) : stored_(stored), largest_(stored) {}

  /// `gained`: J that transfers, walls and strain have added since the start; up to `rounding` J
  /// are nothing. Whether that is below the allowed share of the largest energy so far.
  bool add_step(double kinetic, double strain_work, double gained, double rounding);

  double largest() const { return largest_; }
  double stored() const { return stored_; }
  double steps_above() const { return steps_above_; }
  void restore(double stored, double largest, double steps_above) {
    stored_ = stored;
    largest_ = largest;
    steps_above_ = steps_above;
  }

 private:
  double stored_;             // J, strain of the points, elastic or not
  double largest_;            // J, kinetic and stored together
  double steps_above_ = 0.0;  // in a row, with more gained than is allowed for good
};

}  // namespace lapilli
