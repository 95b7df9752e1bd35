#include "lapilli/output/hdf5_file.hpp"

#include <pthread.h>

#include <mutex>
#include <utility>

#include "lapilli/core/require.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

/// Locked again by the thread that holds it. Never destroyed: a thread may still be writing when
/// the process ends. A process forked from this one finds it free: the fork waits for whoever holds
/// it. (The system's own recursive lock knows its owner by a number that changes with a fork.)
class HdfLock {
 public:
  void lock() {
    if (depth_++ == 0) {
      mutex_.lock();
    }
  }
  void unlock() {
    if (--depth_ == 0) {
      mutex_.unlock();
    }
  }

 private:
  static thread_local int depth_;
  std::mutex mutex_;
};
thread_local int HdfLock::depth_ = 0;

HdfLock& the_lock() {
  static HdfLock* const made = [] {
    static auto* const lock = new HdfLock;
    pthread_atfork([] { lock->lock(); }, [] { lock->unlock(); }, [] { lock->unlock(); });
    H5dont_atexit();  // nothing of HDF5 is left to be cleaned up, and nothing can fail there
    return lock;
  }();
  return *made;
}

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

Hdf5Session::Hdf5Session() {
  the_lock().lock();
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Session::~Hdf5Session() {
  H5Eset_auto2(H5E_DEFAULT, function_, data_);
  the_lock().unlock();
}

void hdf5_check(herr_t status, const std::string& action) {
  if (status < 0) {
    fail(action);
  }
}

Hdf5Id hdf5_open(const std::filesystem::path& path) {
  const Hdf5Id access = access_without_locks();
  return Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose,
                "open '" + path.string() + "' as HDF5");
}

Hdf5Id hdf5_group(hid_t parent, const std::string& name) {
  const Hdf5Id creation = property_list(H5P_GROUP_CREATE);
  hdf5_check(H5Pset_obj_track_times(creation, false), "create group " + name);
  return Hdf5Id(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose,
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

Index hdf5_address(hid_t parent, const std::string& name) {
  const Hdf5Id dataset = open_dataset(parent, name);
  haddr_t address = H5Dget_offset(dataset);
  if (address == HADDR_UNDEF) {  // cut into chunks
    H5Eclear2(H5E_DEFAULT);
    const hsize_t first_row[2] = {0, 0};
    unsigned mask = 0;
    hsize_t size = 0;
    hdf5_check(H5Dget_chunk_info_by_coord(dataset, first_row, &mask, &address, &size),
               "find dataset " + name);
  }
  hdf5_check(address == HADDR_UNDEF ? -1 : 0, "find dataset " + name);
  return static_cast<Index>(address);
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
