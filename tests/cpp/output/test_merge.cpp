#include <catch2/catch.hpp>

#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/merge.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/output/run_lock.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"
#include "output/made_frames.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

namespace {

void write_series(const std::filesystem::path& path, Index planned) {
  MadeFrames made(6);
  VtkhdfWriter writer(path, planned);
  for (Index frame = 0; frame < 5; ++frame) {
    made.go_to(frame);
    writer.write(static_cast<double>(frame), made.points, made.fields());
  }
}

}  // namespace

TEST_CASE("merging keeps every number and needs no other file") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf", merged = folder / "merged.vtkhdf";
  write_series(path, GENERATE(50, 2));
  merge(path, merged);
  const std::vector<double> before = [&] {
    return hdf5_read<double>(hdf5_open(path), "VTKHDF/PointData/velocity");
  }();
  remove_frames(path);
  const Hdf5Id file = hdf5_open(merged);
  const auto velocity = hdf5_read<double>(file, "VTKHDF/PointData/velocity");
  REQUIRE(velocity.size() == 5 * 6 * 3);  // no room left over
  REQUIRE(std::equal(velocity.begin(), velocity.end(), before.begin()));
  REQUIRE(hdf5_read<Index>(file, "VTKHDF/Vertices/Connectivity").size() == 6);
  REQUIRE(hdf5_read<Index>(file, "VTKHDF/PointData/id").size() == 6);
}

TEST_CASE("what cannot be merged says why") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf", merged = folder / "merged.vtkhdf";
  write_series(path, 5);
  const std::string whole = bytes_of(path);
  REQUIRE_THROWS_WITH(merge(path, path), Catch::Contains("itself"));
  REQUIRE_THROWS_WITH(merge(folder / "missing.vtkhdf", merged), Catch::Contains("missing.vtkhdf"));
  REQUIRE_THROWS_WITH(merge(path, folder / "no" / "merged.vtkhdf"),
                      Catch::Contains("No such file"));
  write_series(folder / "other.vtkhdf", 5);
  REQUIRE_THROWS_WITH(merge(path, folder / "other.vtkhdf"), Catch::Contains("other.vtkhdf.data"));
  {
    const RunLock lock(merged);
    REQUIRE_THROWS_WITH(merge(path, merged), Catch::Contains("another run"));
  }
  merge(path, merged);
  merge(path, merged);  // over its like
  REQUIRE_FALSE(std::filesystem::exists(folder / "merged.vtkhdf.lock"));
  REQUIRE_THROWS_WITH(merge(merged, folder / "again.vtkhdf"), Catch::Contains("merged"));
  std::filesystem::remove(data_path(path, 0));
  REQUIRE_THROWS_WITH(merge(path, folder / "again.vtkhdf"), Catch::Contains("run.vtkhdf.data"));
  REQUIRE_FALSE(std::filesystem::exists(folder / "again.vtkhdf"));
  REQUIRE(bytes_of(path) == whole);
}
