#pragma once

#include <filesystem>
#include <string>

#include "lapilli/core/archive.hpp"

namespace lapilli {

/// The state of a run, ready to go on with.
struct Checkpoint {
  std::string fingerprint;  // of the scene it belongs to
  Archive state;
};

/// Write a checkpoint, all at once: a former one stays valid until the new one is on the disk.
/// The file holds, in eight-byte words of this machine: a mark, the format's version, the number of
/// words, their checksum, then the content. Throws OutputError when the disk fails.
void save_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Read a checkpoint. Throws OutputError when the file cannot be read and std::invalid_argument
/// when it is no checkpoint, of another version, cut short or damaged.
Checkpoint load_checkpoint(const std::filesystem::path& path);

/// Throw std::invalid_argument unless the checkpoint belongs to the scene of that fingerprint.
void require_same_scene(const Checkpoint& checkpoint, const std::string& fingerprint,
                        const std::filesystem::path& path);

}  // namespace lapilli
