#include <algorithm>

#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/hdf5_memory.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

Hdf5Id chunked(hid_t parent, const std::string& name, hid_t type, Index rows, int components,
               const Hdf5Pieces& pieces) {
  const std::string action = "lay out dataset " + name;
  const int axes = components == 1 ? 1 : 2;
  const hsize_t all[2] = {static_cast<hsize_t>(rows), static_cast<hsize_t>(components)};
  const hsize_t chunk[2] = {static_cast<hsize_t>(pieces.rows), static_cast<hsize_t>(components)};
  const Hdf5Id space(H5Screate_simple(axes, all, nullptr), H5Sclose, action);
  const Hdf5Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, action);
  hdf5_check(H5Pset_chunk(creation, axes, chunk), action);
  hdf5_check(H5Pset_shuffle(creation), action);
  hdf5_check(H5Pset_deflate(creation, static_cast<unsigned>(pieces.level)), action);
  hdf5_check(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), action);
  hdf5_check(H5Pset_obj_track_times(creation, false), action);
  return Hdf5Id(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                H5Dclose, "create dataset " + name);
}

Index address_of(hid_t dataset, const hsize_t* first_row) {
  unsigned mask = 0;
  haddr_t address = HADDR_UNDEF;
  hsize_t size = 0;
  hdf5_check(H5Dget_chunk_info_by_coord(dataset, first_row, &mask, &address, &size),
             "find a piece of a dataset");
  return static_cast<Index>(address);
}

}  // namespace

Hdf5Id hdf5_pieces(hid_t parent, const std::string& name, hid_t type, Index rows, int components,
                   const Hdf5Pieces& pieces, Index& address) {
  Hdf5Id dataset = chunked(parent, name, type, rows, components, pieces);
  const std::vector<std::byte> room(static_cast<std::size_t>(pieces.room));
  const auto allot = [&](Index piece, std::size_t bytes) {
    const hsize_t first_row[2] = {static_cast<hsize_t>(piece * pieces.rows), 0};
    hdf5_check(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, first_row, bytes, room.data()),
               "lay out dataset " + name);
  };
  const Hdf5RoomOnly nothing_kept;
  // With its first chunk HDF5 makes the table of all of them: the room of the first comes after it.
  allot(0, 1);
  const Index count = rows / pieces.rows;
  for (Index piece = 0; piece < count; ++piece) {
    allot(piece, room.size());
  }
  const hsize_t first[2] = {0, 0}, last[2] = {static_cast<hsize_t>(rows - pieces.rows), 0};
  address = address_of(dataset, first);
  if (address_of(dataset, last) != address + (count - 1) * pieces.room) {
    throw OutputError("cannot lay out dataset " + name + ": this HDF5 puts chunks elsewhere");
  }
  return dataset;
}

}  // namespace lapilli
