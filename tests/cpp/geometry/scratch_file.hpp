#pragma once

#include <atomic>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace lapilli {

/// A file of the given bytes that is removed at the end of its life.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& bytes, const std::string& ending = "") {
    static std::atomic<int> count = 0;
    static const unsigned run = std::random_device{}();
    path_ = (std::filesystem::temp_directory_path() /
             ("lapilli-" + std::to_string(run) + "-" + std::to_string(count++) + ending))
                .string();
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~ScratchFile() { std::filesystem::remove(path_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace lapilli
