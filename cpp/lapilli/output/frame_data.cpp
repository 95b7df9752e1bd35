#include "lapilli/output/frame_data.hpp"

#include <array>
#include <numeric>
#include <sstream>

#include "lapilli/core/require.hpp"
#include "lapilli/output/file_seal.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

hid_t type_of(const Column& column) {
  return column.is_index ? hdf5_type<Index>() : hdf5_type<double>();
}

/// Without links and index, the file still says what it holds: a lost index is made from this.
void describe_contents(hid_t file, const std::vector<Column>& columns, Index points,
                       Index capacity) {
  const std::array<Index, 2> sizes = {points, capacity};
  const Hdf5Id own = hdf5_group(file, "lapilli");
  hdf5_attribute(own, "columns", layout_text(columns));
  hdf5_attribute<Index>(own, "points_and_capacity", sizes);
}

Index address_of(hid_t dataset) { return static_cast<Index>(H5Dget_offset(dataset)); }

}  // namespace

FrameData::FrameData(File file, Addresses addresses, const std::vector<Column>& columns,
                     Index points)
    : file_(std::move(file)), addresses_(std::move(addresses)) {
  for (const Column& column : columns) {
    words_.push_back(points * column.components);
  }
  words_.push_back(FrameEntry::words_of(columns.size()));
}

FrameData FrameData::create(const std::filesystem::path& path, const std::vector<Column>& columns,
                            Index points, Index capacity, bool with_topology) {
  Addresses addresses;
  const Hdf5Image image = hdf5_lay_out([&](hid_t file) {
    if (with_topology) {
      write_topology(hdf5_group(file, "Vertices"), points);
    }
    const Hdf5Id point_data = hdf5_group(file, "PointData");
    for (const Column& column : columns) {
      addresses.push_back(lay_out_column(file, column, points, capacity));
    }
    describe_contents(file, columns, points, capacity);
    const Hdf5Id own(H5Gopen2(file, "lapilli", H5P_DEFAULT), H5Gclose, "lay out the journal");
    addresses.push_back(lay_out_journal(own, columns.size(), capacity));
  });
  AtomicFile file(path);
  image.write_to(file.file());
  FileSeal::of(image, FileSeal::Extent::written).write_to(file.file());
  file.commit();
  return open(path, columns, points, capacity, std::move(addresses), File::Mode::update);
}

FrameData FrameData::open(const std::filesystem::path& path, const std::vector<Column>& columns,
                          Index points, Index capacity, Addresses addresses, File::Mode mode) {
  FrameData data(File(path, mode), std::move(addresses), columns, points);
  const std::int64_t bytes = data.file_.size();
  for (std::size_t column = 0; column < data.words_.size(); ++column) {
    const std::int64_t end = data.byte_of(column, capacity);
    if (end > bytes) {
      throw OutputError(message("'", path.string(), "' is cut short: it has ", bytes,
                                " bytes, its frames need ", end));
    }
  }
  return data;
}

void FrameData::write(std::size_t column, Index slot, const Words& words) {
  file_.write_at(byte_of(column, slot), std::as_bytes(std::span(words)));
}

Words FrameData::read(std::size_t column, Index slot) const {
  Words words(static_cast<std::size_t>(words_[column]));
  file_.read_at(byte_of(column, slot), std::as_writable_bytes(std::span(words)));
  return words;
}

void FrameData::write_entry(Index row, const FrameEntry& entry) {
  write(words_.size() - 1, row, entry.to_words());
}

std::optional<FrameEntry> FrameData::read_entry(Index row) const {
  return FrameEntry::from_words(read(words_.size() - 1, row));
}

void FrameData::clear_entry(Index row) {
  write(words_.size() - 1, row, Words(static_cast<std::size_t>(words_.back()), 0));
}

void write_topology(std::int64_t group, Index points) {
  std::vector<Index> count(static_cast<std::size_t>(points) + 1);
  std::iota(count.begin(), count.end(), Index{0});
  hdf5_write<Index>(group, "Offsets", count);
  hdf5_write<Index>(group, "Connectivity", std::span(count).first(count.size() - 1));
}

Index lay_out_column(std::int64_t group, const Column& column, Index points, Index slots) {
  const Hdf5Id dataset =
      hdf5_dataset(group, column.name, type_of(column), slots * points, column.components);
  hdf5_attribute(dataset, "unit", column.unit);
  return address_of(dataset);
}

Index lay_out_journal(std::int64_t group, std::size_t columns, Index frames) {
  const auto words = static_cast<int>(FrameEntry::words_of(columns));
  return address_of(hdf5_dataset(group, "journal", hdf5_type<Index>(), frames, words));
}

std::string layout_text(const std::vector<Column>& columns) {
  std::ostringstream text;
  for (const Column& column : columns) {
    text << column.name << '\t' << column.unit << '\t' << column.components << '\t'
         << column.is_index << '\t' << column.may_rest << '\n';
  }
  return text.str();
}

std::vector<Column> parse_layout(const std::string& layout) {
  std::vector<Column> columns;
  std::istringstream lines(layout);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream parts(line);
    Column column;
    std::getline(parts, column.name, '\t');
    std::getline(parts, column.unit, '\t');
    parts >> column.components >> column.is_index >> column.may_rest;
    require(!parts.fail() && (column.name == "Points" || column.name.starts_with("PointData/")),
            "its list of columns is damaged");
    columns.push_back(column);
  }
  return columns;
}

}  // namespace lapilli
