#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lapilli {

/// Memory for arrays of megabytes on pages of two megabytes, where the system has them: particles
/// and nodes are met in an order that spreads over many small pages, and looking those up costs.
/// Smaller arrays are allocated as usual.
template <class T>
struct LargePages {
  using value_type = T;
  static constexpr std::size_t page = std::size_t{1} << 21;

  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other>&) {}  // NOLINT(google-explicit-constructor): an allocator

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    const bool large = bytes >= page;
    const std::size_t size = large ? (bytes + page - 1) / page * page : bytes;
    void* memory = large ? std::aligned_alloc(page, size) : std::malloc(size);
    if (memory == nullptr) {
      throw std::bad_alloc();
    }
#ifdef __linux__
    if (large) {
      madvise(memory, size, MADV_HUGEPAGE);  // a wish: without it the pages are small
    }
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

/// A vector whose memory lies on large pages once it is large.
template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}  // namespace lapilli
