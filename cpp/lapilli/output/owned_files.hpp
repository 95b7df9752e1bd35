#pragma once

#include <filesystem>

namespace lapilli {

/// The kinds of files that a run leaves.
enum class OwnedFile { frames, data, checkpoint, record };

/// Throw std::invalid_argument unless lapilli may put such a file there: nothing is there yet, or
/// an empty file, or one that lapilli wrote. Links, folders, devices and files of others are
/// refused: they are never overwritten and never removed.
void require_replaceable(const std::filesystem::path& path, OwnedFile kind);

}  // namespace lapilli
