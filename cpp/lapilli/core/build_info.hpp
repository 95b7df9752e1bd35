#pragma once

#include <string>

namespace lapilli {

/// How this library was built.
struct BuildInfo {
  const char* version;
  const char* compiler;    // "GNU 12.2.0"
  const char* kernel_set;  // processor level that the kernels are compiled for
  const char* build_type;
};

const BuildInfo& build_info();

/// What `--version` prints: a line each, and the number of threads.
std::string version_text();

}  // namespace lapilli
