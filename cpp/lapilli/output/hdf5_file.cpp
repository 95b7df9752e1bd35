#include "lapilli/output/hdf5_file.hpp"

#include <utility>

#include "lapilli/core/require.hpp"
#include "lapilli/output/file.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

herr_t note_reason(unsigned, const H5E_error2_t* error, void* data) {
  auto& reason = *static_cast<std::string*>(data);
  if (reason.empty() && error->desc != nullptr) {
    reason = error->desc;
  }
  return 0;
}

[[noreturn]] void fail(const std::string& action) {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, note_reason, &reason);
  H5Eclear2(H5E_DEFAULT);
  throw OutputError(message("cannot ", action, reason.empty() ? "" : ": ", reason));
}

Hdf5Id property_list(hid_t kind) {
  return Hdf5Id(H5Pcreate(kind), H5Pclose, "make an HDF5 property list");
}

Hdf5Id access_without_locks() {
  Hdf5Id access = property_list(H5P_FILE_ACCESS);
#if H5_VERSION_GE(1, 10, 7)
  hdf5_check(H5Pset_file_locking(access, false, true), "turn off file locking");
#endif
  return access;
}

Hdf5Id space_of(Index rows, int components) {
  const hsize_t sizes[2] = {static_cast<hsize_t>(rows), static_cast<hsize_t>(components)};
  return Hdf5Id(H5Screate_simple(components == 1 ? 1 : 2, sizes, nullptr), H5Sclose,
                "make an HDF5 dataspace");
}

Hdf5Id open_dataset(hid_t parent, const std::string& name) {
  return Hdf5Id(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "open dataset " + name);
}

Hdf5Id open_attribute(hid_t object, const std::string& name) {
  return Hdf5Id(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "read attribute " + name);
}

Hdf5Id create_attribute(hid_t object, const std::string& name, hid_t type, hid_t space) {
  return Hdf5Id(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                "write attribute " + name);
}

Hdf5Id text_type(std::size_t size) {
  Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text type");
  hdf5_check(H5Tset_size(type, std::max<std::size_t>(size, 1)), "make a text type");
  hdf5_check(H5Tset_strpad(type, H5T_STR_NULLPAD), "make a text type");
  return type;
}

}  // namespace

Hdf5Id::Hdf5Id(hid_t id, Close how, const std::string& action)
    : id_(id), close_(how), action_(action) {
  if (id_ < 0) {
    fail(action_);
  }
}

Hdf5Id::~Hdf5Id() {
  if (id_ >= 0) {
    close_(id_);
  }
}

Hdf5Id::Hdf5Id(Hdf5Id&& other) noexcept
    : id_(std::exchange(other.id_, -1)), close_(other.close_), action_(std::move(other.action_)) {}

void Hdf5Id::close() { hdf5_check(close_(std::exchange(id_, -1)), action_); }

Hdf5Quiet::Hdf5Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Quiet::~Hdf5Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

void hdf5_check(herr_t status, const std::string& action) {
  if (status < 0) {
    fail(action);
  }
}

Hdf5Id hdf5_create(const std::filesystem::path& path) {
  const Hdf5Id access = access_without_locks();
  return Hdf5Id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose,
                "create '" + path.string() + "'");
}

void hdf5_create_whole(const std::filesystem::path& path, const std::function<void(hid_t)>& fill) {
  const std::filesystem::path temporary = with_ending(path, ".tmp");
  const File says_plainly_why_not(temporary, File::Mode::create);
  try {
    Hdf5Id file = hdf5_create(temporary);
    fill(file);
    file.close();
    File(temporary, File::Mode::update).sync();
    rename_durably(temporary, path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

Hdf5Id hdf5_create_in_memory() {
  const Hdf5Id access = property_list(H5P_FILE_ACCESS);
  hdf5_check(H5Pset_fapl_core(access, 1 << 16, false), "make an HDF5 file in memory");
  return Hdf5Id(H5Fcreate("memory", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose,
                "make an HDF5 file in memory");
}

Hdf5Id hdf5_open(const std::filesystem::path& path) {
  const Hdf5Id access = access_without_locks();
  return Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose,
                "open '" + path.string() + "' as HDF5");
}

std::vector<std::byte> hdf5_image(hid_t file) {
  hdf5_check(H5Fflush(file, H5F_SCOPE_GLOBAL), "make an HDF5 image");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  hdf5_check(size < 0 ? -1 : 0, "make an HDF5 image");
  std::vector<std::byte> image(static_cast<std::size_t>(size));
  hdf5_check(H5Fget_file_image(file, image.data(), image.size()) < 0 ? -1 : 0,
             "make an HDF5 image");
  return image;
}

Hdf5Id hdf5_group(hid_t parent, const std::string& name) {
  return Hdf5Id(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                "create group " + name);
}

template <>
hid_t hdf5_type<double>() {
  return H5T_NATIVE_DOUBLE;
}

template <>
hid_t hdf5_type<Index>() {
  return H5T_NATIVE_INT64;
}

Hdf5Id hdf5_dataset(hid_t parent, const std::string& name, hid_t type, Index rows, int components) {
  const Hdf5Id space = space_of(rows, components);
  const Hdf5Id creation = property_list(H5P_DATASET_CREATE);
  hdf5_check(H5Pset_layout(creation, H5D_CONTIGUOUS), "lay out dataset " + name);
  hdf5_check(H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY), "lay out dataset " + name);
  hdf5_check(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), "lay out dataset " + name);
  // Without times a repeated run gives the same bytes.
  hdf5_check(H5Pset_obj_track_times(creation, false), "lay out dataset " + name);
  return Hdf5Id(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                H5Dclose, "create dataset " + name);
}

template <class T>
void hdf5_write(hid_t parent, const std::string& name, std::span<const T> values, int components) {
  const Index rows = static_cast<Index>(values.size()) / components;
  const Hdf5Id dataset = hdf5_dataset(parent, name, hdf5_type<T>(), rows, components);
  if (!values.empty()) {
    hdf5_check(H5Dwrite(dataset, hdf5_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               "write dataset " + name);
  }
}

void hdf5_write_rows(hid_t dataset, hid_t type, Index begin, Index rows, int components,
                     const void* numbers) {
  const hsize_t start[2] = {static_cast<hsize_t>(begin), 0};
  const hsize_t size[2] = {static_cast<hsize_t>(rows), static_cast<hsize_t>(components)};
  const Hdf5Id memory = space_of(rows, components);
  const Hdf5Id on_disk(H5Dget_space(dataset), H5Sclose, "write rows");
  hdf5_check(H5Sselect_hyperslab(on_disk, H5S_SELECT_SET, start, nullptr, size, nullptr),
             "write rows");
  hdf5_check(H5Dwrite(dataset, type, memory, on_disk, H5P_DEFAULT, numbers), "write rows");
}

template <class T>
std::vector<T> hdf5_read(hid_t parent, const std::string& name) {
  const Hdf5Id dataset = open_dataset(parent, name);
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose, "read dataset " + name);
  std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  if (!values.empty()) {
    hdf5_check(H5Dread(dataset, hdf5_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
               "read dataset " + name);
  }
  return values;
}

bool hdf5_exists(hid_t parent, const std::string& name) {
  return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0;
}

void hdf5_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose, "write attribute " + name);
  const Hdf5Id type = text_type(text.size());
  const Hdf5Id attribute = create_attribute(object, name, type, space);
  hdf5_check(H5Awrite(attribute, type, text.c_str()), "write attribute " + name);
}

template <class T>
void hdf5_attribute(hid_t object, const std::string& name, std::span<const T> values, bool scalar) {
  const Hdf5Id space = scalar ? Hdf5Id(H5Screate(H5S_SCALAR), H5Sclose, "write attribute " + name)
                              : space_of(static_cast<Index>(values.size()), 1);
  const Hdf5Id attribute = create_attribute(object, name, hdf5_type<T>(), space);
  hdf5_check(H5Awrite(attribute, hdf5_type<T>(), values.data()), "write attribute " + name);
}

std::string hdf5_read_text_attribute(hid_t object, const std::string& name) {
  const Hdf5Id attribute = open_attribute(object, name);
  const Hdf5Id stored(H5Aget_type(attribute), H5Tclose, "read attribute " + name);
  std::string text(H5Tget_size(stored), '\0');
  const Hdf5Id type = text_type(text.size());
  hdf5_check(H5Aread(attribute, type, text.data()), "read attribute " + name);
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

template <class T>
std::vector<T> hdf5_read_attribute(hid_t object, const std::string& name) {
  const Hdf5Id attribute = open_attribute(object, name);
  const Hdf5Id space(H5Aget_space(attribute), H5Sclose, "read attribute " + name);
  std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  hdf5_check(H5Aread(attribute, hdf5_type<T>(), values.data()), "read attribute " + name);
  return values;
}

template void hdf5_write<double>(hid_t, const std::string&, std::span<const double>, int);
template void hdf5_write<Index>(hid_t, const std::string&, std::span<const Index>, int);
template std::vector<double> hdf5_read<double>(hid_t, const std::string&);
template std::vector<Index> hdf5_read<Index>(hid_t, const std::string&);
template void hdf5_attribute<double>(hid_t, const std::string&, std::span<const double>, bool);
template void hdf5_attribute<Index>(hid_t, const std::string&, std::span<const Index>, bool);
template std::vector<Index> hdf5_read_attribute<Index>(hid_t, const std::string&);

}  // namespace lapilli
