#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/merge.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/output/verify.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"
#include "output/made_frames.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

namespace {

constexpr Index frames = 4;

FrameOptions form(bool single, int compression) { return {{}, single, compression, false}; }

FrameOptions asking(std::vector<std::string> fields) {
  return {std::move(fields), false, 0, false};
}

void write_frames(VtkhdfWriter& writer, MadeFrames& made, Index from, Index to) {
  for (Index frame = from; frame < to; ++frame) {
    made.go_to(frame);
    writer.write(0.5 * static_cast<double>(frame), made.points, made.fields());
  }
}

void write_series(const std::filesystem::path& path, Index points, Index planned,
                  const FrameOptions& options) {
  MadeFrames made(points);
  VtkhdfWriter writer(path, planned, options);
  write_frames(writer, made, 0, frames);
}

std::vector<std::string> names_in(const std::filesystem::path& path) {
  std::vector<std::string> names;
  for (const Column& column : read_index(path).columns) {
    names.push_back(field_name(column));
  }
  return names;
}

/// The temperature of a frame, from the reader of frames and as HDF5 itself finds it.
void check_temperature(const std::filesystem::path& path, Index points, Index frame) {
  FrameReader reader(path);
  const std::size_t column = reader.column_of("temperature");
  const Words words = reader.read(column, frame);
  const Hdf5Id file = hdf5_open(path);
  const Hdf5Id dataset(H5Dopen2(file, "VTKHDF/PointData/temperature", H5P_DEFAULT), H5Dclose, "");
  const Hdf5Id space(H5Dget_space(dataset), H5Sclose, "");
  const auto offset = static_cast<hsize_t>(
      hdf5_read<Index>(file, "VTKHDF/Steps/PointDataOffsets/temperature")[frame]);
  const auto size = static_cast<hsize_t>(points);
  hdf5_check(H5Sselect_hyperslab(space, H5S_SELECT_SET, &offset, nullptr, &size, nullptr), "");
  const Hdf5Id memory(H5Screate_simple(1, &size, nullptr), H5Sclose, "");
  std::vector<double> read(static_cast<std::size_t>(points));
  hdf5_check(H5Dread(dataset, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, read.data()), "read");
  const bool single = reader.index().columns[column].is_single;
  Index wrong = 0;
  for (Index k = 0; k < points; ++k) {
    const double wanted = static_cast<double>(k) + 1000.0 * static_cast<double>(frame);
    double found = 0.0;
    if (single) {
      float number = 0.0F;
      std::memcpy(&number, reinterpret_cast<const char*>(words.data()) + 4 * k, 4);
      found = static_cast<double>(number);
    } else {
      std::memcpy(&found, words.data() + k, 8);
    }
    // Whole numbers below 2^24: exact in four bytes too.
    wrong += found == wanted && read[static_cast<std::size_t>(k)] == wanted ? 0 : 1;
  }
  REQUIRE(wrong == 0);
}

/// Positions have eight bytes a number, fields as many as was asked for.
void check_widths(const std::filesystem::path& path, bool single) {
  const Hdf5Id file = hdf5_open(path);
  const Hdf5Id position(H5Dopen2(file, "VTKHDF/Points", H5P_DEFAULT), H5Dclose, "");
  const Hdf5Id stress(H5Dopen2(file, "VTKHDF/PointData/stress", H5P_DEFAULT), H5Dclose, "");
  REQUIRE(H5Tget_size(Hdf5Id(H5Dget_type(position), H5Tclose, "")) == 8);
  REQUIRE(H5Tget_size(Hdf5Id(H5Dget_type(stress), H5Tclose, "")) == (single ? 4 : 8));
}

std::int64_t bytes_on_disk(const std::filesystem::path& path) {
  struct stat status = {};
  REQUIRE(::stat(path.c_str(), &status) == 0);
  return status.st_blocks * 512;
}

/// Numbers that no compression makes much smaller.
void make_noise(MadeFrames& made) {
  for (std::size_t k = 0; k < made.temperature.size(); ++k) {
    made.temperature[k] = std::sin(1e5 * static_cast<double>(k + 1));
  }
}

}  // namespace

TEST_CASE("frames hold the fields that were asked for, and what every frame holds") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  using Names = std::vector<std::string>;
  write_series(path, 5, frames, asking({"velocity"}));
  REQUIRE(names_in(path) == Names{"position", "id", "body", "volume", "velocity"});
  write_series(path, 5, frames, asking({}));
  REQUIRE(names_in(path) == Names{"position", "id", "body", "volume"});
  write_series(path, 5, frames, asking({"stress", "volume", "velocity"}));
  REQUIRE(names_in(path) == Names{"position", "id", "body", "volume", "velocity", "stress"});
}

TEST_CASE("a field that there is not is named, with the nearest one and all there are") {
  const ScratchFolder folder;
  const FrameOptions options = asking({"velocty"});
  REQUIRE_THROWS_WITH(write_series(folder / "run.vtkhdf", 5, frames, options),
                      Catch::Contains("output.fields") && Catch::Contains("'velocty'") &&
                          Catch::Contains("did you mean 'velocity'?") &&
                          Catch::Contains("temperature, velocity, stress"));
}

TEST_CASE("fields of four bytes, compressed and in several files, read as written everywhere") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf", merged = folder / "merged.vtkhdf";
  const bool single = GENERATE(false, true);
  const int compression = GENERATE(0, 1, 9);
  const Index points = GENERATE(Index{1}, Index{7}, Index{40001});  // 40001: two pieces a slot
  const Index planned = GENERATE(Index{4}, Index{1});
  CAPTURE(single, compression, points, planned);
  write_series(path, points, planned, form(single, compression));
  merge(path, merged);
  for (const auto& file : {path, merged}) {
    const Verification found = verify(file);
    REQUIRE(found.damages.empty());
    REQUIRE(found.whole_frames == frames);
    for (Index frame = 0; frame < frames; ++frame) {
      check_temperature(file, points, frame);
    }
  }
  check_widths(path, single);
  std::filesystem::remove(path);
  REQUIRE(rebuild_index(path) == frames);
  check_temperature(path, points, frames - 1);
}

TEST_CASE("what four bytes cannot hold is refused") {
  const ScratchFolder folder;
  MadeFrames made(3);
  made.go_to(0);
  made.temperature[1] = 1e39;
  VtkhdfWriter writer(folder / "run.vtkhdf", 1, form(true, 0));
  REQUIRE_THROWS_WITH(writer.write(0.0, made.points, made.fields()),
                      Catch::Contains("temperature") && Catch::Contains("single"));
}

TEST_CASE("compressed frames take less room on the disk, merged also in length") {
  const ScratchFolder folder;
  constexpr Index points = 40000;
  const auto raw = folder / "raw.vtkhdf", path = folder / "run.vtkhdf",
             merged = folder / "merged.vtkhdf";
  write_series(raw, points, frames, {});
  write_series(path, points, frames, form(false, 4));
  merge(path, merged);
  const auto whole = static_cast<std::int64_t>(std::filesystem::file_size(data_path(raw, 0)));
  // Whole numbers in order: an eighth is far above what they take.
  REQUIRE(bytes_on_disk(data_path(path, 0)) < whole / 8);
  REQUIRE(static_cast<std::int64_t>(std::filesystem::file_size(merged)) < whole / 8);
}

TEST_CASE("a compressed series goes on after any of its frames with the same bytes") {
  const ScratchFolder folder;
  const auto whole = folder / "whole.vtkhdf", path = folder / "run.vtkhdf";
  const FrameOptions options = form(GENERATE(false, true), 6);
  const Index points = GENERATE(Index{7}, Index{40001});
  MadeFrames made(points);
  VtkhdfWriter undisturbed(whole, 3, options);
  write_frames(undisturbed, made, 0, 6);
  const Index keep = GENERATE(1, 3);
  {
    VtkhdfWriter first(path, 3, options);
    write_frames(first, made, 0, keep);
    made.go_to(keep);
    make_noise(made);  // longer than what the resumed run writes there
    for (int more = 0; more < 2; ++more) {
      first.write(0.5 * static_cast<double>(keep + more), made.points, made.fields());
    }
  }
  VtkhdfWriter second = VtkhdfWriter::resume(path, keep, 3, options);
  write_frames(second, made, keep, 6);
  for (std::size_t file = 0; file < read_index(whole).capacities.size(); ++file) {
    const bool same = bytes_of(data_path(path, file)) == bytes_of(data_path(whole, file));
    REQUIRE(same);
  }
}

TEST_CASE("no flipped bit of a compressed data file gives a wrong number") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  write_series(path, 5, frames, form(true, 1));
  std::vector<Words> written;
  for (Index frame = 0; frame < frames; ++frame) {
    FrameReader reader(path);
    written.push_back(reader.read(reader.column_of("temperature"), frame));
  }
  const std::string bytes = bytes_of(data_path(path, 0));
  Index noticed = 0;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 1009) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    put_bytes(data_path(path, 0), damaged);
    for (Index frame = 0; frame < frames; ++frame) {
      Words read;
      try {
        FrameReader reader(path);
        read = reader.read(reader.column_of("temperature"), frame);
      } catch (const OutputError& error) {
        REQUIRE_THAT(error.what(), Catch::Contains("frame " + std::to_string(frame)));
        ++noticed;
        continue;
      }
      REQUIRE(read == written[static_cast<std::size_t>(frame)]);
    }
  }
  REQUIRE(noticed > 0);
}

TEST_CASE("a series of another form is not gone on with, and says what differs") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  write_series(path, 5, frames, form(false, 2));
  MadeFrames made(5);
  made.go_to(0);
  const auto check = [&](const FrameOptions& options) {
    require_same_form(path, made.points, made.fields(), options);
  };
  REQUIRE_NOTHROW(check(form(false, 2)));
  REQUIRE_THROWS_WITH(check(form(false, 3)),
                      Catch::Contains("compression 2") && Catch::Contains("compression 3"));
  REQUIRE_THROWS_WITH(check(form(true, 2)), Catch::Contains("double") && Catch::Contains("single"));
  REQUIRE_THROWS_WITH(check({std::vector<std::string>{"stress"}, false, 2, false}),
                      Catch::Contains("fields temperature, velocity, stress") &&
                          Catch::Contains("asks for fields stress"));
}
