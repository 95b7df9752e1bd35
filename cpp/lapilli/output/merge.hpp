#pragma once

#include <filesystem>

namespace lapilli {

/// Gather a series of frames, index and data files, into one self-contained VTKHDF file with only
/// the room that its frames use. Works on a run that is still writing: its frames so far are taken.
/// The target appears all at once; it must not be the output of a run, this or another, which its
/// data files beside it tell. Throws std::invalid_argument when it is, or when `from` holds no
/// frames of lapilli, OutputError when a file cannot be read or written or a run writes the target.
void merge(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace lapilli
