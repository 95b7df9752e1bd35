#include <catch2/catch.hpp>
#include <cstring>

#include "lapilli/core/require.hpp"
#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/merge.hpp"
#include "lapilli/output/verify.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"
#include "output/made_frames.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

namespace {

constexpr Index count = 9, frames = 5;

/// Before frame k the points 2 k - 1 and 2 k - 2 leave.
void write_frames(VtkhdfWriter& writer, MadeFrames& made, Index from, Index to) {
  for (Index frame = from; frame < to; ++frame) {
    std::vector<Index> rows;
    for (Index row = 0; row < made.points.size(); ++row) {
      if (made.points.id()[row] < 2 * frame) {
        rows.push_back(row);
      }
    }
    made.points.leave(std::move(rows));
    made.points.remove_leaving();
    made.go_to(frame);
    writer.write(0.5 * static_cast<double>(frame), made.points, made.fields());
  }
}

FrameOptions options_of(int compression) { return {{}, false, compression, true}; }

void check_frames(const std::filesystem::path& path) {
  FrameReader reader(path);
  REQUIRE(reader.index().frames() == frames);
  const Hdf5Id file = hdf5_open(path);
  const auto points = hdf5_read<Index>(file, "VTKHDF/NumberOfPoints");
  REQUIRE(points == std::vector<Index>{9, 7, 5, 3, 1});
  REQUIRE(hdf5_read<Index>(file, "VTKHDF/Steps/PartOffsets") == std::vector<Index>{0, 1, 2, 3, 4});
  for (const char* kind : {"Vertices", "Lines", "Polygons", "Strips"}) {
    const std::string name = message("VTKHDF/", kind, "/NumberOfCells");
    const std::vector<Index> none(frames, 0);
    REQUIRE(hdf5_read<Index>(file, name) == (std::string(kind) == "Vertices" ? points : none));
  }
  for (Index frame = 0; frame < frames; ++frame) {
    REQUIRE(reader.index().points_of(frame) == count - 2 * frame);
    const Words ids = reader.read(reader.column_of("id"), frame);
    const Words temperatures = reader.read(reader.column_of("temperature"), frame);
    for (Index row = 0; row < count - 2 * frame; ++row) {
      double temperature = 0.0;
      std::memcpy(&temperature, &temperatures[row], sizeof temperature);
      REQUIRE(static_cast<Index>(ids[row]) == row + 2 * frame);
      REQUIRE(temperature == static_cast<double>(row + 2 * frame + 1000 * frame));
    }
  }
}

}  // namespace

TEST_CASE("frames hold the points that are left, in order of id") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf", merged = folder / "merged.vtkhdf";
  const int compression = GENERATE(0, 6);
  MadeFrames made(count);
  VtkhdfWriter writer(path, GENERATE(Index{5}, Index{2}), options_of(compression));
  write_frames(writer, made, 0, frames);
  check_frames(path);
  merge(path, merged);
  check_frames(merged);
  REQUIRE(verify(merged).damages.empty());
  std::filesystem::remove(path);
  REQUIRE(rebuild_index(path) == frames);
  check_frames(path);
  REQUIRE(verify(path).damages.empty());
}

TEST_CASE("a series whose points leave goes on with the same bytes") {
  const ScratchFolder folder;
  const auto whole = folder / "whole.vtkhdf", path = folder / "run.vtkhdf";
  const int compression = GENERATE(0, 6);
  MadeFrames made(count), again(count);
  VtkhdfWriter undisturbed(whole, frames, options_of(compression));
  write_frames(undisturbed, made, 0, frames);
  {
    VtkhdfWriter first(path, frames, options_of(compression));
    write_frames(first, again, 0, 3);
  }
  const Index keep = 2;
  MadeFrames resumed(count);
  VtkhdfWriter second = VtkhdfWriter::resume(path, keep, frames, options_of(compression));
  write_frames(second, resumed, keep, frames);
  check_frames(path);
  const bool same = bytes_of(data_path(path, 0)) == bytes_of(data_path(whole, 0));
  REQUIRE(same);
}

TEST_CASE("points do not come back, and leave only where that was said") {
  const ScratchFolder folder;
  MadeFrames many(count), few(count - 1);
  many.go_to(0), few.go_to(0);
  VtkhdfWriter writer(folder / "run.vtkhdf", 2, options_of(0));
  writer.write(0.0, few.points, few.fields());
  REQUIRE_THROWS_WITH(writer.write(1.0, many.points, many.fields()), Catch::Contains("8 points"));
  VtkhdfWriter fixed(folder / "fixed.vtkhdf", 2);
  fixed.write(0.0, many.points, many.fields());
  REQUIRE_THROWS_WITH(fixed.write(1.0, few.points, few.fields()), Catch::Contains("9 points"));
}
