#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "lapilli/output/file.hpp"
#include "lapilli/output/hdf5_memory.hpp"

namespace lapilli {

/// What lapilli writes behind the end of an HDF5 file (where HDF5 does not look): which bytes HDF5
/// laid out and their checksum. By it a file is known as one of lapilli, and a damaged structure is
/// found before HDF5 reads it. The numbers of the frames have checksums of their own.
struct FileSeal {
  struct Piece {
    std::int64_t begin = 0, size = 0;  // bytes
  };

  std::int64_t hdf5_size = 0;  // bytes of the file before the seal
  std::vector<Piece> pieces;
  std::uint64_t checksum = 0;

  /// Of every byte, or of those that HDF5 wrote: the others are room for numbers.
  enum class Extent { whole, written };

  static FileSeal of(const Hdf5Image& image, Extent extent);
  void write_to(File& file) const;
  /// The seal of a file; nothing where there is none or where it is damaged itself.
  static std::optional<FileSeal> find(const File& file);
  /// Whether the pieces are as they were sealed.
  bool fits(const File& file) const;

 private:
  using Read = std::function<void(std::int64_t offset, std::span<std::byte> bytes)>;
  std::uint64_t sum(const Read& read) const;
};

/// Throw OutputError when the structure of a file of frames is damaged, std::invalid_argument when
/// it has no seal.
void require_whole(const File& file);

}  // namespace lapilli
