#include "lapilli/output/frame_data.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "lapilli/core/require.hpp"
#include "lapilli/output/file_seal.hpp"
#include "lapilli/output/frame_datasets.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

/// Without links and index, the file still says what it holds: a lost index is made from this.
void describe_contents(hid_t file, const FrameLayout& layout, Index capacity) {
  const std::array<Index, 2> sizes = {layout.points, capacity};
  const Hdf5Id own = hdf5_group(file, "lapilli");
  hdf5_attribute(own, "columns", layout_text(layout.columns));
  hdf5_attribute<Index>(own, "points_and_capacity", sizes);
  write_form(own, layout);
}

Index address_of(hid_t dataset) { return static_cast<Index>(H5Dget_offset(dataset)); }

}  // namespace

FrameData::FrameData(File file, Addresses addresses, const FrameLayout& layout)
    : file_(std::move(file)),
      addresses_(std::move(addresses)),
      layout_(layout),
      entry_words_(FrameEntry::words_of(layout.columns.size(), layout.points_leave)) {}

FrameData FrameData::create(const std::filesystem::path& path, const FrameLayout& layout,
                            Index capacity, bool with_topology) {
  Addresses addresses;
  const Hdf5Image image = hdf5_lay_out(
      [&](hid_t file) {
        if (with_topology) {
          write_topology(hdf5_group(file, "Vertices"), layout.points);
        }
        const Hdf5Id point_data = hdf5_group(file, "PointData");
        for (std::size_t column = 0; column < layout.columns.size(); ++column) {
          addresses.push_back(lay_out_column(file, layout, column, capacity));
        }
        describe_contents(file, layout, capacity);
        const Hdf5Id own(H5Gopen2(file, "lapilli", H5P_DEFAULT), H5Gclose, "lay out the journal");
        addresses.push_back(lay_out_journal(own, layout, capacity));
      },
      layout.is_compressed());
  AtomicFile file(path);
  image.write_to(file.file());
  FileSeal::of(image, FileSeal::Extent::written).write_to(file.file());
  file.commit();
  return open(path, layout, capacity, std::move(addresses), File::Mode::update);
}

FrameData FrameData::open(const std::filesystem::path& path, const FrameLayout& layout,
                          Index capacity, Addresses addresses, File::Mode mode) {
  FrameData data(File(path, mode), std::move(addresses), layout);
  const std::int64_t bytes = data.file_.size();
  std::int64_t end = data.byte_of_entry(capacity);
  for (std::size_t column = 0; column < layout.columns.size(); ++column) {
    end = std::max(end, data.byte_of(column, capacity));
  }
  if (end > bytes) {
    throw OutputError(message("'", path.string(), "' is cut short: it has ", bytes,
                              " bytes, its frames need ", end));
  }
  return data;
}

void FrameData::write(std::size_t column, Index slot, const Words& words) {
  if (layout_.is_compressed()) {
    write_packed(column, slot, words);
    return;
  }
  const auto bytes = static_cast<std::size_t>(layout_.slot_bytes(column));
  file_.write_at(byte_of(column, slot), std::as_bytes(std::span(words)).first(bytes));
}

Words FrameData::read(std::size_t column, Index slot) const {
  if (layout_.is_compressed()) {
    return read_packed(column, slot);
  }
  Words words(static_cast<std::size_t>(layout_.slot_words(column)), 0);
  const auto bytes = static_cast<std::size_t>(layout_.slot_bytes(column));
  file_.read_at(byte_of(column, slot), std::as_writable_bytes(std::span(words)).first(bytes));
  return words;
}

void FrameData::write_entry(Index row, const FrameEntry& entry) {
  const Words words = entry.to_words();
  file_.write_at(byte_of_entry(row), std::as_bytes(std::span(words)));
}

std::optional<FrameEntry> FrameData::read_entry(Index row) const {
  Words words(static_cast<std::size_t>(entry_words_));
  file_.read_at(byte_of_entry(row), std::as_writable_bytes(std::span(words)));
  return FrameEntry::from_words(words);
}

void FrameData::clear_entry(Index row) {
  const Words zeros(static_cast<std::size_t>(entry_words_), 0);
  file_.write_at(byte_of_entry(row), std::as_bytes(std::span(zeros)));
}

void write_topology(std::int64_t group, Index points) {
  std::vector<Index> count(static_cast<std::size_t>(points) + 1);
  std::iota(count.begin(), count.end(), Index{0});
  hdf5_write<Index>(group, "Offsets", count);
  hdf5_write<Index>(group, "Connectivity", std::span(count).first(count.size() - 1));
}

Index lay_out_column(std::int64_t group, const FrameLayout& layout, std::size_t column,
                     Index slots) {
  const Column& kind = layout.columns[column];
  const Index rows = slots * layout.slot_rows();
  if (layout.is_compressed()) {
    const Hdf5Pieces pieces{layout.piece_rows, layout.piece_room[column], layout.compression};
    Index address = 0;
    const Hdf5Id dataset =
        hdf5_pieces(group, kind.name, type_of(kind), rows, kind.components, pieces, address);
    hdf5_attribute(dataset, "unit", kind.unit);
    return address;
  }
  const Hdf5Id dataset = hdf5_dataset(group, kind.name, type_of(kind), rows, kind.components);
  hdf5_attribute(dataset, "unit", kind.unit);
  return address_of(dataset);
}

Index lay_out_journal(std::int64_t group, const FrameLayout& layout, Index frames) {
  const auto words =
      static_cast<int>(FrameEntry::words_of(layout.columns.size(), layout.points_leave));
  return address_of(hdf5_dataset(group, "journal", hdf5_type<Index>(), frames, words));
}

}  // namespace lapilli
