#pragma once

#include <catch2/catch.hpp>

#include "dynamics/fixtures.hpp"

namespace dynamics_test {

/// All that a run would be resumed from.
template <int Dim>
Archive snapshot(const Run<Dim>& run) {
  Archive archive;
  run.points.save(archive);
  run.solver->save(archive);
  return archive;
}

/// `steps` automatic steps of what `make` makes give the same bytes with 1, 2 and 4 threads, and
/// from a snapshot after `stop` steps. `look` at the run of one thread at its end.
template <class Make, class Look>
void check_same_bytes(const Make& make, int steps, int stop, const Look& look) {
  Archive whole, middle;
  for (int threads : {1, 2, 4}) {
    auto run = make();
    run->start(threads);
    for (int k = 0; k < steps; ++k) {
      if (k == stop && threads == 1) {
        middle = snapshot(*run);
      }
      run->advance(run->automatic_step());
    }
    CAPTURE(threads);
    if (threads == 1) {
      whole = snapshot(*run);
      look(*run);
    } else {
      CHECK(whole.arrays() == snapshot(*run).arrays());
    }
  }
  set_thread_count(0);
  auto resumed = make();
  resumed->start();
  resumed->points.load(middle);
  resumed->solver->load(middle);
  // The clock of the fixture is no part of it.
  for (int k = stop; k < steps; ++k) {
    resumed->advance(resumed->automatic_step());
  }
  CHECK(whole.arrays() == snapshot(*resumed).arrays());
}

}  // namespace dynamics_test
