#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "lapilli/core/require.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/hdf5_memory.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"
#include "output/made_frames.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

namespace {

constexpr Index count = 7;

void write_frames(VtkhdfWriter& writer, MadeFrames& made, Index from, Index to) {
  for (Index frame = from; frame < to; ++frame) {
    made.go_to(frame);
    writer.write(0.5 * static_cast<double>(frame), made.points, made.fields());
  }
}

/// Read one frame's rows of one column as a reader of the index finds them.
std::vector<double> frame_of(const std::filesystem::path& path, const std::string& column,
                             const std::string& offsets, Index frame, int components) {
  const Hdf5Id file = hdf5_open(path);
  const std::vector<double> all = hdf5_read<double>(file, "VTKHDF/" + column);
  const Index begin = hdf5_read<Index>(file, "VTKHDF/Steps/" + offsets)[frame] * components;
  REQUIRE(begin + count * components <= static_cast<Index>(all.size()));
  return {all.begin() + begin, all.begin() + begin + count * components};
}

void check_frames(const std::filesystem::path& path, Index frames, bool moves = true) {
  REQUIRE(read_index(path).frames() == frames);
  for (Index frame = 0; frame < frames; ++frame) {
    const auto step = static_cast<double>(frame);
    const auto position = frame_of(path, "Points", "PointOffsets", frame, 3);
    const auto temperature =
        frame_of(path, "PointData/temperature", "PointDataOffsets/temperature", frame, 1);
    const auto stress = frame_of(path, "PointData/stress", "PointDataOffsets/stress", frame, 9);
    for (Index k = 0; k < count; ++k) {
      const auto id = static_cast<double>(k);
      REQUIRE(position[3 * k] == id);
      REQUIRE(position[3 * k + 1] == (moves ? step : 0.0));
      REQUIRE(position[3 * k + 2] == 0.0);
      REQUIRE(temperature[k] == id + 1000.0 * step);
      const std::vector<double> row(stress.begin() + 9 * k, stress.begin() + 9 * (k + 1));
      REQUIRE(row == std::vector<double>{id, step, 0, -id, -step, 0, 0, 0, 0});
    }
  }
}

}  // namespace

TEST_CASE("frames hold rows in order of id, vectors and tensors filled up") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  MadeFrames made(count);
  VtkhdfWriter writer(path, 4);
  write_frames(writer, made, 0, 4);
  check_frames(path, 4);
  REQUIRE(read_index(path).times == std::vector<double>{0.0, 0.5, 1.0, 1.5});
}

TEST_CASE("points that do not move are stored once") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  MadeFrames made(count, false);
  VtkhdfWriter writer(path, 5);
  write_frames(writer, made, 0, 5);
  check_frames(path, 5, false);
  const FrameIndex index = read_index(path);
  for (std::size_t k = 0; k < index.columns.size(); ++k) {
    REQUIRE(index.next_slot(k) == (index.columns[k].may_rest ? 1 : 5));
  }
}

TEST_CASE("more frames than planned go on in further data files") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  MadeFrames made(count);
  VtkhdfWriter writer(path, 2);
  write_frames(writer, made, 0, 9);
  REQUIRE(read_index(path).capacities == std::vector<Index>{2, 2, 4, 8});
  check_frames(path, 9);
}

TEST_CASE("a series goes on after any of its frames and gives the same bytes") {
  const ScratchFolder folder;
  const auto whole = folder / "whole.vtkhdf", path = folder / "run.vtkhdf";
  const bool moves = GENERATE(true, false);
  MadeFrames made(count, moves);
  VtkhdfWriter undisturbed(whole, 3);
  write_frames(undisturbed, made, 0, 8);
  const Index keep = GENERATE(0, 1, 3, 5);
  {
    VtkhdfWriter first(path, 3);
    write_frames(first, made, 0, 5);
  }
  VtkhdfWriter second = VtkhdfWriter::resume(path, keep, 3);
  REQUIRE(std::filesystem::exists(path) == (keep > 0));
  if (keep > 0) {
    check_frames(path, keep, moves);
  }
  write_frames(second, made, keep, 8);
  check_frames(path, 8, moves);
  REQUIRE(read_index(path).slots == read_index(whole).slots);
  for (std::size_t file = 0; file < read_index(whole).capacities.size(); ++file) {
    REQUIRE(bytes_of(data_path(path, file)) == bytes_of(data_path(whole, file)));
  }
}

TEST_CASE("a series shorter than the checkpoint says is refused") {
  const ScratchFolder folder;
  MadeFrames made(count);
  VtkhdfWriter writer(folder / "run.vtkhdf", 2);
  write_frames(writer, made, 0, 2);
  REQUIRE_THROWS_WITH(VtkhdfWriter::resume(folder / "run.vtkhdf", 3),
                      Catch::Contains("it holds 2") && Catch::Contains("run.vtkhdf"));
}

TEST_CASE("fields that do not fit are refused and the frames before stay") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  MadeFrames made(count);
  VtkhdfWriter writer(path, 4);
  write_frames(writer, made, 0, 2);
  made.go_to(2);
  SECTION("wrong size") {
    made.temperature.pop_back();
    REQUIRE_THROWS_WITH(writer.write(1.0, made.points, made.fields()),
                        Catch::Contains("'temperature' has 6 values"));
  }
  SECTION("a field less") {
    auto fields = made.fields();
    fields.pop_back();
    REQUIRE_THROWS_AS(writer.write(1.0, made.points, fields), std::invalid_argument);
  }
  SECTION("a name that is taken") {
    auto fields = made.fields();
    fields[0].name = "volume";
    REQUIRE_THROWS_WITH(writer.write(1.0, made.points, fields), Catch::Contains("'volume'"));
  }
  check_frames(path, 2);
}

TEST_CASE("a path that cannot be written names the file and the reason") {
  const ScratchFolder folder;
  MadeFrames made(count);
  made.go_to(0);
  put_bytes(folder / "plain", "a file, not a folder");
  VtkhdfWriter writer(folder / "plain" / "run.vtkhdf");
  REQUIRE_THROWS_WITH(writer.write(0.0, made.points, made.fields()),
                      Catch::Contains("run.vtkhdf.data") && Catch::Contains("Not a directory"));
  REQUIRE_THROWS_WITH(VtkhdfWriter(folder / "run.vtk"), Catch::Contains(".vtkhdf"));
}

TEST_CASE("a disk that refuses a frame leaves the last index valid, and writing can go on") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  MadeFrames made(count);
  VtkhdfWriter writer(path, 4);
  write_frames(writer, made, 0, 2);
  rlimit before = {};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = GENERATE(0, 1500, 4000, 10000);  // bytes: refuses numbers or index
  const auto former = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  made.go_to(2);
  std::string said;
  try {
    writer.write(1.0, made.points, made.fields());
  } catch (const OutputError& error) {
    said = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, former);
  REQUIRE_THAT(said, Catch::Contains("run.vtkhdf") && Catch::Contains("File too large"));
  check_frames(path, 2);
  REQUIRE(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}) == 2);
  write_frames(writer, made, 2, 4);
  check_frames(path, 4);
}

TEST_CASE("files of others are not taken for frames") {
  const ScratchFolder folder;
  put_bytes(folder / "run.vtkhdf", "plain text");
  REQUIRE_THROWS_WITH(read_index(folder / "run.vtkhdf"), Catch::Contains("run.vtkhdf"));
  const auto path = folder / "other.vtkhdf";
  {
    File file(path, File::Mode::create);
    hdf5_lay_out([](hid_t) {}).write_to(file);
  }
  REQUIRE_THROWS_WITH(read_index(path), Catch::Contains("no frames of lapilli"));
}
