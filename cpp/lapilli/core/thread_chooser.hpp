#pragma once

namespace lapilli {

/// How many threads the steps of a simulation use where nobody said: few points, or a processor
/// that others keep busy, are worked through faster by fewer, which only the clock can tell. Steps
/// are timed with the present number, now and then with half or twice as many, and the fastest
/// stays. Nothing that is computed depends on it.
class ThreadChooser {
 public:
  /// For the next step, at most `most`.
  int threads(int most);
  /// The step took so long, s.
  void took(double seconds);

 private:
  void end_trial();

  int most_ = 0;         // that there are
  int chosen_ = 0;       // the fastest so far
  int tried_ = 0;        // of the present trial
  int direction_ = -1;   // of the next trial: halve or double
  double best_ = 0.0;    // s a step, with the chosen number
  double spent_ = 0.0;   // s, in the present trial
  int steps_ = 0;        // of the present trial
  double patience_ = 0;  // s, until the next trial
};

}  // namespace lapilli
