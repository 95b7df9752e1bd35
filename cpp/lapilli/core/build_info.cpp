#include "lapilli/core/build_info.hpp"

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {

const BuildInfo& build_info() {
  static constexpr BuildInfo info{LAPILLI_VERSION, LAPILLI_COMPILER, LAPILLI_KERNEL_SET,
                                  LAPILLI_BUILD_TYPE};
  return info;
}

std::string version_text() {
  const BuildInfo& info = build_info();
  return message("lapilli ", info.version, "\ncompiler: ", info.compiler,
                 "\nkernel set: ", info.kernel_set, "\nbuild type: ", info.build_type,
                 "\nthreads: ", thread_count());
}

}  // namespace lapilli
