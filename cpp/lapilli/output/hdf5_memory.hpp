#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace lapilli {

class File;

/// The bytes of an HDF5 file laid out in memory, in pages; what HDF5 never wrote is zero and takes
/// no memory, so that room for terabytes can be laid out.
struct Hdf5Image {
  static constexpr std::int64_t page_bytes = 4096;

  std::map<std::int64_t, std::vector<std::byte>> pages;  // by number
  std::map<std::int64_t, std::int64_t> written;          // begin and end of what HDF5 wrote, bytes
  std::int64_t size = 0;                                 // of the file, bytes

  void read(std::int64_t offset, std::byte* to, std::size_t count) const;
  void write(std::int64_t offset, const std::byte* from, std::size_t count);
  /// Write every page to a file; the file must be new.
  void write_to(File& file) const;

 private:
  void note_written(std::int64_t begin, std::int64_t end);
};

/// Lay out an HDF5 file by `fill`. HDF5 itself never touches a disk, so that no failure of one can
/// leave a half-closed file inside of it. With `chunks` the form of the file is that of HDF5 1.10,
/// which looks up a chunk at once. Throws OutputError when HDF5 refuses.
Hdf5Image hdf5_lay_out(const std::function<void(hid_t)>& fill, bool chunks = false);

/// While it lives, numbers that HDF5 writes into an image are given room but are not kept.
class Hdf5RoomOnly {
 public:
  Hdf5RoomOnly();
  ~Hdf5RoomOnly();
  Hdf5RoomOnly(const Hdf5RoomOnly&) = delete;
  Hdf5RoomOnly& operator=(const Hdf5RoomOnly&) = delete;
};

}  // namespace lapilli
