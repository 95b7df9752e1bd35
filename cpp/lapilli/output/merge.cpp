#include "lapilli/output/merge.hpp"

#include <algorithm>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/output/file_seal.hpp"
#include "lapilli/output/frame_index.hpp"
#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/owned_files.hpp"
#include "lapilli/output/run_lock.hpp"

namespace lapilli {
namespace {

/// The index of one file with only the room that is used, and the byte of each column in it.
FrameIndex one_file(const FrameIndex& from, const std::filesystem::path& to) {
  FrameIndex index = from;
  index.merged = true;
  index.name = to.filename().string();
  index.addresses = {{}};
  Index most = from.frames();
  for (std::size_t column = 0; column < from.columns.size(); ++column) {
    most = std::max(most, from.next_slot(column));
  }
  index.capacities = {most};
  return index;
}

/// Room for the longest piece of each column, instead of the longest that there could be.
void fit_room(FrameReader& from, FrameIndex& index) {
  for (std::size_t column = 0; column < index.piece_room.size(); ++column) {
    Index longest = 1, seen = -1;
    for (const Index number : index.slots[column]) {
      allow_interruption();
      if (number != seen) {
        const auto [data, slot] = from.place(number);
        longest = std::max(longest, data.longest_piece(column, slot));
        seen = number;
      }
    }
    index.piece_room[column] = longest;
  }
}

void lay_out(hid_t file, FrameIndex& index) {
  write_index_group(file, index);
  const Hdf5Id group(H5Gopen2(file, "VTKHDF", H5P_DEFAULT), H5Gclose, "write the index");
  const Hdf5Id vertices(H5Gopen2(group, "Vertices", H5P_DEFAULT), H5Gclose, "write the index");
  write_topology(vertices, index.points);
  for (std::size_t column = 0; column < index.columns.size(); ++column) {
    index.addresses[0].push_back(lay_out_column(group, index, column, index.next_slot(column)));
  }
  const Hdf5Id own(H5Gopen2(file, "lapilli", H5P_DEFAULT), H5Gclose, "write the index");
  index.addresses[0].push_back(lay_out_journal(own, index, index.frames()));
  write_addresses(file, index);
}

/// The bytes of a column in one frame, compared with their checksum.
std::vector<std::byte> whole_slot(FrameReader& from, const FrameIndex& index, std::size_t column,
                                  Index frame) {
  const Words words = from.read(column, frame);
  if (index.is_compressed()) {
    const auto [data, slot] = from.place(index.slots[column][static_cast<std::size_t>(frame)]);
    return data.bytes_of_slot(column, slot, index.piece_room[column]);
  }
  const auto bytes = std::as_bytes(std::span(words));
  return {bytes.begin(), bytes.begin() + index.slot_bytes(column)};
}

/// Copy frame by frame; what rests is written once.
void copy_numbers(FrameReader& from, const FrameIndex& index, File& to) {
  const Addresses& address = index.addresses[0];
  std::vector<Index> written(index.columns.size(), -1);
  for (Index frame = 0; frame < index.frames(); ++frame) {
    allow_interruption();
    const FrameEntry entry = from.entry(frame);
    for (std::size_t column = 0; column < index.columns.size(); ++column) {
      const Index slot = entry.slots[column];
      if (slot != written[column]) {
        to.write_at(address[column] + slot * index.slot_bytes(column),
                    whole_slot(from, index, column, frame));
        written[column] = slot;
      }
    }
    const Words words = entry.to_words();
    to.write_at(address.back() + frame * static_cast<Index>(words.size()) * 8,
                std::as_bytes(std::span(words)));
  }
}

}  // namespace

void merge(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code ignored;
  require(std::filesystem::exists(from, ignored), "there is no file '", from.string(), "'");
  require(!std::filesystem::equivalent(from, to, ignored), "merge '", from.string(),
          "' into another file, not into itself");
  require_replaceable(to, OwnedFile::frames);
  require(!std::filesystem::exists(data_path(to, 0), ignored), "'", to.string(),
          "' is the output of a run, whose numbers lie in '", data_path(to, 0).string(),
          "': merge into another file");
  FrameReader reader(from);
  require(!reader.index().merged, "'", from.string(), "' is merged into one file already");
  FrameIndex index = one_file(reader.index(), to);
  fit_room(reader, index);
  const Hdf5Image image =
      hdf5_lay_out([&](hid_t file) { lay_out(file, index); }, index.is_compressed());
  const RunLock lock(to);
  AtomicFile file(to);
  image.write_to(file.file());
  FileSeal::of(image, FileSeal::Extent::written).write_to(file.file());
  copy_numbers(reader, index, file.file());
  file.commit();
}

}  // namespace lapilli
