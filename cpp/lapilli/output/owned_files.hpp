#pragma once

#include <filesystem>
#include <vector>

namespace lapilli {

/// The kinds of files that a run leaves.
enum class OwnedFile { frames, data, checkpoint, record };

/// Throw std::invalid_argument unless lapilli may put such a file there: nothing is there yet, or
/// an empty file, or one that lapilli wrote. Links, folders, devices and files of others are
/// refused: they are never overwritten and never removed.
void require_replaceable(const std::filesystem::path& path, OwnedFile kind);

/// The same for the history beside a record: a table says nothing of who wrote it. One of lapilli
/// has the columns that the record tells of.
void require_replaceable_history(const std::filesystem::path& history,
                                 const std::filesystem::path& record);

/// Throw std::invalid_argument where one of the files to be written is, by whatever name, one of
/// those that are read.
void require_apart(const std::vector<std::filesystem::path>& written,
                   const std::vector<std::filesystem::path>& inputs);

}  // namespace lapilli
