#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lapilli/core/vector.hpp"
#include "lapilli/output/run_lock.hpp"

namespace lapilli {

/// What was found in the files of a run, or in a merged file.
struct Verification {
  Index frames = 0;                  // that the index names
  Index whole_frames = 0;            // of which every number fits its checksum
  std::vector<std::string> damages;  // each with file, frame and field; empty: all is well
};

/// Read everything that a run left, index, structure, every number and the checkpoints, and compare
/// it with its checksums. Writes nothing. Throws OutputError when the index itself cannot be read,
/// std::invalid_argument when lapilli did not write it.
Verification verify(const std::filesystem::path& frames);

/// Make a lost or damaged index anew from the data files beside it; returns the number of frames.
/// Throws OutputError when these cannot be read or are damaged too, or while a run writes them.
Index rebuild_index(const std::filesystem::path& frames);
/// The same by the run that holds the lock of these frames.
Index rebuild_index(const std::filesystem::path& frames, const RunLock& held);

}  // namespace lapilli
