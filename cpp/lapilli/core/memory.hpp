#pragma once

#include <new>
#include <string>
#include <utility>

namespace lapilli {

/// Bytes this process may still take: the least of what the machine has free, what its control
/// group and its limit of address space leave. Infinite where the system says nothing.
double available_memory();

/// An allocation that failed, with a sentence instead of a name.
class OutOfMemory : public std::bad_alloc {
 public:
  explicit OutOfMemory(std::string text) : text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

/// "2.4 GB", "13 MB".
std::string readable_bytes(double bytes);

/// Throws OutOfMemory that says what could not be done, what the process holds and what is left.
[[noreturn]] void explain_no_memory(const char* what);

/// Run `work`; where it finds no memory, throw OutOfMemory that says what it was, how much the
/// process holds and how much there was.
template <class Work>
decltype(auto) with_memory_for(const char* what, const Work& work) {
  try {
    return work();
  } catch (const OutOfMemory&) {
    throw;
  } catch (const std::bad_alloc&) {
    explain_no_memory(what);
  }
}

}  // namespace lapilli
