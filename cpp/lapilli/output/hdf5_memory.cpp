#include "lapilli/output/hdf5_memory.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <span>

#include "lapilli/output/file.hpp"
#include "lapilli/output/hdf5_file.hpp"

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

namespace lapilli {
namespace {

bool room_only = false;  // whoever calls HDF5 has locked it

/// What HDF5 holds while the file is open; HDF5 fills in the first member.
struct MemoryFile {
  H5FD_t base = {};
  Hdf5Image* image = nullptr;
  haddr_t end_of_addresses = 0;
};

MemoryFile& file_of(H5FD_t* file) { return *reinterpret_cast<MemoryFile*>(file); }
const MemoryFile& file_of(const H5FD_t* file) { return *reinterpret_cast<const MemoryFile*>(file); }

H5FD_t* open_file(const char*, unsigned, hid_t access, haddr_t) {
  const auto* image = static_cast<Hdf5Image* const*>(H5Pget_driver_info(access));
  if (image == nullptr) {
    return nullptr;
  }
  auto file = std::make_unique<MemoryFile>();
  file->image = *image;
  return &file.release()->base;
}

herr_t close_file(H5FD_t* file) {
  const std::unique_ptr<MemoryFile> closed(&file_of(file));
  closed->image->size = static_cast<std::int64_t>(closed->end_of_addresses);
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

haddr_t end_of_addresses(const H5FD_t* file, H5FD_mem_t) { return file_of(file).end_of_addresses; }

herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  file_of(file).end_of_addresses = end;
  return 0;
}

herr_t read_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t offset, std::size_t size, void* to) {
  file_of(file).image->read(static_cast<std::int64_t>(offset), static_cast<std::byte*>(to), size);
  return 0;
}

herr_t write_bytes(H5FD_t* file, H5FD_mem_t kind, hid_t, haddr_t offset, std::size_t size,
                   const void* from) {
  if (room_only && kind == H5FD_MEM_DRAW) {
    return 0;
  }
  try {
    file_of(file).image->write(static_cast<std::int64_t>(offset),
                               static_cast<const std::byte*>(from), size);
    return 0;
  } catch (const std::bad_alloc&) {
    return -1;
  }
}

H5FD_class_t driver_class() {
  H5FD_class_t driver = {};
#if H5_VERSION_GE(1, 13, 0)
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(600);  // 512 and more: free for anybody
#endif
  driver.name = "lapilli_memory";
  driver.maxaddr = std::numeric_limits<std::int64_t>::max();
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(Hdf5Image*);
  driver.open = open_file;
  driver.close = close_file;
  driver.query = query;
  driver.get_eoa = end_of_addresses;
  driver.set_eoa = set_end_of_addresses;
  driver.get_eof = [](const H5FD_t* file, H5FD_mem_t) { return file_of(file).end_of_addresses; };
  driver.read = read_bytes;
  driver.write = write_bytes;
  const H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(kinds), std::end(kinds), std::begin(driver.fl_map));
  return driver;
}

hid_t driver() {
  static const H5FD_class_t made = driver_class();
  static const hid_t id = H5FDregister(&made);
  return id;
}

/// Call work(page number, begin in the page, bytes, begin in the whole) for each page touched.
template <class Work>
void by_page(std::int64_t offset, std::size_t size, const Work& work) {
  constexpr std::int64_t page = Hdf5Image::page_bytes;
  for (std::size_t done = 0; done < size;) {
    const std::int64_t at = offset + static_cast<std::int64_t>(done), begin = at % page;
    const std::size_t bytes = std::min(size - done, static_cast<std::size_t>(page - begin));
    work(at / page, begin, bytes, done);
    done += bytes;
  }
}

}  // namespace

void Hdf5Image::read(std::int64_t offset, std::byte* to, std::size_t count) const {
  by_page(offset, count,
          [&](std::int64_t number, std::int64_t begin, std::size_t bytes, auto done) {
            const auto found = pages.find(number);
            if (found == pages.end()) {
              std::memset(to + done, 0, bytes);
            } else {
              std::memcpy(to + done, found->second.data() + begin, bytes);
            }
          });
}

void Hdf5Image::write(std::int64_t offset, const std::byte* from, std::size_t count) {
  by_page(offset, count,
          [&](std::int64_t number, std::int64_t begin, std::size_t bytes, auto done) {
            std::vector<std::byte>& page = pages[number];
            page.resize(page_bytes);
            std::memcpy(page.data() + begin, from + done, bytes);
          });
  note_written(offset, offset + static_cast<std::int64_t>(count));
}

/// Join a range with those that it touches.
void Hdf5Image::note_written(std::int64_t begin, std::int64_t end) {
  auto next = written.upper_bound(begin);
  if (next != written.begin() && std::prev(next)->second >= begin) {
    --next;
  }
  while (next != written.end() && next->first <= end) {
    begin = std::min(begin, next->first);
    end = std::max(end, next->second);
    next = written.erase(next);
  }
  written[begin] = end;
}

void Hdf5Image::write_to(File& file) const {
  constexpr std::size_t most_at_once = 256;  // pages
  std::vector<std::byte> run;
  for (auto page = pages.begin(); page != pages.end();) {
    const std::int64_t first = page->first;
    std::int64_t next = first;
    run.clear();
    for (; page != pages.end() && page->first == next &&
           run.size() < most_at_once * static_cast<std::size_t>(page_bytes);
         ++page, ++next) {
      run.insert(run.end(), page->second.begin(), page->second.end());
    }
    const auto room = static_cast<std::size_t>(size - first * page_bytes);
    file.write_at(first * page_bytes, std::span(run).first(std::min(run.size(), room)));
  }
  file.resize(size);
}

Hdf5RoomOnly::Hdf5RoomOnly() { room_only = true; }

Hdf5RoomOnly::~Hdf5RoomOnly() { room_only = false; }

Hdf5Image hdf5_lay_out(const std::function<void(hid_t)>& fill, bool chunks) {
  const Hdf5Session session;
  Hdf5Image image;
  Hdf5Image* const laid_out = &image;
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make an HDF5 property list");
  hdf5_check(H5Pset_driver(access, driver(), &laid_out), "lay out an HDF5 file in memory");
  if (chunks) {
    hdf5_check(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110),
               "lay out an HDF5 file in memory");
    hdf5_check(H5Pset_small_data_block_size(access, 0), "lay out an HDF5 file in memory");
  }
  const Hdf5Id creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make an HDF5 property list");
  hdf5_check(H5Pset_obj_track_times(creation, false), "lay out an HDF5 file in memory");
  Hdf5Id file(H5Fcreate("in memory", H5F_ACC_TRUNC, creation, access), H5Fclose,
              "lay out an HDF5 file in memory");
  fill(file);
  file.close();
  return image;
}

}  // namespace lapilli
