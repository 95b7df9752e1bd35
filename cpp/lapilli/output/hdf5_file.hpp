#pragma once

#include <hdf5.h>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// An HDF5 identifier, closed when it leaves its scope. A failed identifier throws OutputError.
class Hdf5Id {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Id(hid_t id, Close how, const std::string& action);
  ~Hdf5Id();
  Hdf5Id(Hdf5Id&& other) noexcept;
  Hdf5Id& operator=(Hdf5Id&&) = delete;

  operator hid_t() const { return id_; }  // NOLINT: used where HDF5 wants the number
  /// Close now and throw when that fails: a file is written in full only then.
  void close();

 private:
  hid_t id_;
  Close close_;
  std::string action_;
};

/// Keeps HDF5 from printing while in scope; errors come as exceptions.
class Hdf5Quiet {
 public:
  Hdf5Quiet();
  ~Hdf5Quiet();
  Hdf5Quiet(const Hdf5Quiet&) = delete;
  Hdf5Quiet& operator=(const Hdf5Quiet&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

// Every function below throws OutputError with the innermost of HDF5's own reasons. Files are never
// locked: a simulation must not fail because somebody looks at its frames.

/// Throw when `status` is negative.
void hdf5_check(herr_t status, const std::string& action);

Hdf5Id hdf5_create(const std::filesystem::path& path);
/// Make a file by `fill`, all at once: it appears under its name complete and on the disk, or not
/// at all.
void hdf5_create_whole(const std::filesystem::path& path, const std::function<void(hid_t)>& fill);
/// A file that lives in memory; `hdf5_image` gives its bytes.
Hdf5Id hdf5_create_in_memory();
Hdf5Id hdf5_open(const std::filesystem::path& path);
std::vector<std::byte> hdf5_image(hid_t file);

Hdf5Id hdf5_group(hid_t parent, const std::string& name);

/// The two kinds of numbers that frames hold, eight bytes each.
template <class T>
hid_t hdf5_type();

/// A dataset of rows (x components when more than 1) with all its room on disk; nothing is filled.
Hdf5Id hdf5_dataset(hid_t parent, const std::string& name, hid_t type, Index rows, int components);
template <class T>
void hdf5_write(hid_t parent, const std::string& name, std::span<const T> values,
                int components = 1);
/// Write some rows, eight bytes a number, of a dataset that exists.
void hdf5_write_rows(hid_t dataset, hid_t type, Index begin, Index rows, int components,
                     const void* numbers);
template <class T>
std::vector<T> hdf5_read(hid_t parent, const std::string& name);
bool hdf5_exists(hid_t parent, const std::string& name);

void hdf5_attribute(hid_t object, const std::string& name, const std::string& text);
template <class T>
void hdf5_attribute(hid_t object, const std::string& name, std::span<const T> values,
                    bool scalar = false);
std::string hdf5_read_text_attribute(hid_t object, const std::string& name);
template <class T>
std::vector<T> hdf5_read_attribute(hid_t object, const std::string& name);

}  // namespace lapilli
