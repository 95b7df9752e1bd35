#pragma once

#include <hdf5.h>

#include <filesystem>
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

/// Whoever calls HDF5 has one of these in scope: one thread at a time, since HDF5 keeps its state
/// in global variables, and nothing printed; errors come as exceptions. May be nested.
class Hdf5Session {
 public:
  Hdf5Session();
  ~Hdf5Session();
  Hdf5Session(const Hdf5Session&) = delete;
  Hdf5Session& operator=(const Hdf5Session&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

// Every function below throws OutputError with the innermost of HDF5's own reasons. Files are read
// without locks of HDF5: a simulation must not fail because somebody looks at its frames.

/// Throw when `status` is negative.
void hdf5_check(herr_t status, const std::string& action);

Hdf5Id hdf5_open(const std::filesystem::path& path);

Hdf5Id hdf5_group(hid_t parent, const std::string& name);

/// The kinds of numbers of eight bytes that files hold.
template <class T>
hid_t hdf5_type();

/// A dataset of rows (x components when more than 1) with all its room on disk; nothing is filled.
Hdf5Id hdf5_dataset(hid_t parent, const std::string& name, hid_t type, Index rows, int components);

/// How a dataset is cut into chunks that are shuffled and deflated.
struct Hdf5Pieces {
  Index rows = 0;  // of a piece
  Index room = 0;  // bytes of the file for each
  int level = 0;   // of deflate, 1 .. 9
};

/// A dataset of such pieces, whose rooms lie one after the other from the byte `address` on; none
/// of them is filled. For `hdf5_lay_out` with chunks.
Hdf5Id hdf5_pieces(hid_t parent, const std::string& name, hid_t type, Index rows, int components,
                   const Hdf5Pieces& pieces, Index& address);
template <class T>
void hdf5_write(hid_t parent, const std::string& name, std::span<const T> values,
                int components = 1);
template <class T>
std::vector<T> hdf5_read(hid_t parent, const std::string& name);
/// The byte at which a dataset begins that is one piece in its file, or the first of its chunks.
Index hdf5_address(hid_t parent, const std::string& name);
bool hdf5_exists(hid_t parent, const std::string& name);

void hdf5_attribute(hid_t object, const std::string& name, const std::string& text);
template <class T>
void hdf5_attribute(hid_t object, const std::string& name, std::span<const T> values,
                    bool scalar = false);
std::string hdf5_read_text_attribute(hid_t object, const std::string& name);
template <class T>
std::vector<T> hdf5_read_attribute(hid_t object, const std::string& name);

}  // namespace lapilli
