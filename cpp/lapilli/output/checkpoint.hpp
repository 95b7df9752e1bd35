#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "lapilli/core/archive.hpp"

namespace lapilli {

/// The first word of every checkpoint of lapilli.
inline constexpr std::uint64_t checkpoint_mark = 0x6b6368696c70616c;

/// The state of a run, ready to go on with.
struct Checkpoint {
  std::string fingerprint;  // of the scene it belongs to
  Archive state;
  std::string identity = {};  // of that scene: a line "key<tab>value" for each of its settings
};

/// The checkpoints of an output, the newest first: `run.checkpoint` and, in case that one is
/// damaged, the one before, `run.checkpoint.previous`.
std::array<std::filesystem::path, 2> checkpoint_paths(const std::filesystem::path& output);

/// Write a checkpoint, all at once, keeping the one before as `path`.previous: a former one stays
/// valid until the new one is on the disk.
/// The file holds, in eight-byte words of this machine: a mark, the format's version, the number of
/// words, their checksum, then the content. Throws OutputError when the disk fails.
void save_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Read a checkpoint. Throws OutputError when the file cannot be read and std::invalid_argument
/// when it is no checkpoint, of another version, cut short or damaged.
Checkpoint load_checkpoint(const std::filesystem::path& path);

/// Throw std::invalid_argument unless the checkpoint belongs to the scene of that fingerprint; says
/// which settings differ where both identities are known.
void require_same_scene(const Checkpoint& checkpoint, const std::string& fingerprint,
                        const std::string& identity, const std::filesystem::path& path);

}  // namespace lapilli
