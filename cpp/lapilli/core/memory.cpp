#include "lapilli/core/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number in a file that holds one; infinite when it holds none ("max") or is not there.
double number_in(const std::string& path) {
  std::ifstream file(path);
  double number = 0.0;
  return file >> number ? number : unlimited;
}

double free_in_machine() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  for (double kilobytes = 0.0; file >> name >> kilobytes; std::getline(file, unit)) {
    if (name == "MemAvailable:") {
      return 1024.0 * kilobytes;
    }
  }
  return unlimited;
}

/// A control group and those around it, each with a limit of its own (version 2, then 1).
double free_in_group() {
  double least = unlimited;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const bool second = line.starts_with("0::");
    if (!second && line.find(":memory:") == std::string::npos) {
      continue;
    }
    const std::string root = second ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    std::string path = line.substr(line.rfind(':') + 1);
    for (;;) {
      const std::string folder = root + (path == "/" ? "" : path) + "/memory.";
      const double limit = number_in(folder + (second ? "max" : "limit_in_bytes"));
      if (std::isfinite(limit)) {
        least =
            std::min(least, limit - number_in(folder + (second ? "current" : "usage_in_bytes")));
      }
      if (path.empty() || path == "/") {
        break;
      }
      path.resize(path.rfind('/'));
    }
  }
  return least;
}

/// Bytes of address space and of memory that this process holds.
std::pair<double, double> held() {
  std::ifstream file("/proc/self/statm");
  double pages = 0.0, resident = 0.0;
  file >> pages >> resident;
  const auto page = static_cast<double>(::sysconf(_SC_PAGESIZE));
  return {pages * page, resident * page};
}

double free_in_address_space() {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return unlimited;
  }
  return static_cast<double>(limit.rlim_cur) - held().first;
}

}  // namespace

double available_memory() {
  const double least = std::min({free_in_machine(), free_in_group(), free_in_address_space()});
  return std::max(0.0, least);
}

std::string readable_bytes(double bytes) {
  std::ostringstream text;
  text.precision(3);
  text << bytes / (bytes >= 1e9 ? 1e9 : 1e6) << (bytes >= 1e9 ? " GB" : " MB");
  return text.str();
}

void explain_no_memory(const char* what) {
  const std::string taken = readable_bytes(held().second);
  throw OutOfMemory(message("there is not enough memory to ", what, ": this process holds ", taken,
                            ", and ", readable_bytes(available_memory()),
                            " are left for it; take a larger grid.cell, fewer points or threads"));
}

}  // namespace lapilli
