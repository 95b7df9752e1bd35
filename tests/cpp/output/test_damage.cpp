#include <catch2/catch.hpp>

#include "lapilli/core/require.hpp"
#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/merge.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/output/runner.hpp"
#include "lapilli/output/verify.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"
#include "output/decay.hpp"
#include "output/made_frames.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

namespace {

constexpr Index points = 5, frames = 4;

void write_series(const std::filesystem::path& path, Index planned) {
  MadeFrames made(points);
  VtkhdfWriter writer(path, planned);
  for (Index frame = 0; frame < frames; ++frame) {
    made.go_to(frame);
    writer.write(0.5 * static_cast<double>(frame), made.points, made.fields());
  }
}

using AllNumbers = std::vector<std::vector<Words>>;

/// Numbers of every frame and column; empty where they are refused.
AllNumbers read_all(const std::filesystem::path& path) {
  AllNumbers all;
  try {
    FrameReader reader(path);
    for (Index frame = 0; frame < reader.index().frames(); ++frame) {
      auto& columns = all.emplace_back();
      for (std::size_t column = 0; column < reader.index().columns.size(); ++column) {
        try {
          columns.push_back(reader.read(column, frame));
        } catch (const OutputError& error) {
          REQUIRE_THAT(error.what(), Catch::Contains("frame " + std::to_string(frame)) ||
                                         Catch::Contains("missing") || Catch::Contains("short"));
          columns.emplace_back();
        }
      }
    }
  } catch (const OutputError&) {
  } catch (const std::invalid_argument&) {
  }
  return all;
}

/// Nothing of what is read may differ from what was written.
void require_nothing_wrong(const AllNumbers& read, const AllNumbers& written) {
  for (std::size_t frame = 0; frame < read.size(); ++frame) {
    for (std::size_t column = 0; column < read[frame].size(); ++column) {
      REQUIRE((read[frame][column].empty() || read[frame][column] == written[frame][column]));
    }
  }
}

void flip(std::string& bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
}

}  // namespace

TEST_CASE("the data file of another run beside an index is found") {
  const ScratchFolder folder;
  const auto ours = folder / "ours.vtkhdf", other = folder / "other.vtkhdf";
  write_series(ours, 4);
  {
    MadeFrames made(points);
    VtkhdfWriter writer(other, 4);
    for (Index frame = 0; frame < frames; ++frame) {
      made.go_to(frame + 1);  // the same times and slots, other numbers
      writer.write(0.5 * static_cast<double>(frame), made.points, made.fields());
    }
  }
  std::filesystem::copy_file(data_path(other, 0), data_path(ours, 0),
                             std::filesystem::copy_options::overwrite_existing);
  for (Index frame = 0; frame < frames; ++frame) {
    REQUIRE_THROWS_WITH(FrameReader(ours).read(0, frame),
                        Catch::Contains("does not belong to") && Catch::Contains("ours.vtkhdf'"));
  }
  CHECK(verify(ours).whole_frames == 0);
  CHECK(!verify(ours).damages.empty());
  CHECK_THROWS_WITH(VtkhdfWriter::resume(ours, 2), Catch::Contains("does not belong to"));
  rebuild_index(ours);  // then the frames are those of the other run
  CHECK(verify(ours).damages.empty());
  CHECK(read_all(ours) == read_all(other));
}

TEST_CASE("a resumed series has the index of one that never stopped") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  write_series(path, 4);
  const std::string whole = bytes_of(path);
  MadeFrames made(points);
  {
    VtkhdfWriter writer = VtkhdfWriter::resume(path, 2, 4);
    for (Index frame = 2; frame < frames; ++frame) {
      made.go_to(frame);
      writer.write(0.5 * static_cast<double>(frame), made.points, made.fields());
    }
  }
  CHECK(bytes_of(path) == whole);
  // An index without checksums is read, and has them again after a resume.
  FrameIndex index = read_index(path);
  index.sums.clear();
  write_index(path, index);
  CHECK(verify(path).damages.empty());
  VtkhdfWriter::resume(path, frames, 4);
  CHECK(bytes_of(path) == whole);
}

TEST_CASE("no flipped bit of any file gives a wrong number, and verify finds those that matter") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  write_series(path, GENERATE(4, 1));
  const AllNumbers written = read_all(path);
  REQUIRE(written.size() == frames);
  REQUIRE(verify(path).damages.empty());
  REQUIRE(verify(path).whole_frames == frames);
  for (const auto& file : {path, data_path(path, 0)}) {
    const std::string whole = bytes_of(file);
    for (std::size_t bit = 3; bit < 8 * whole.size(); bit += 1013) {
      std::string damaged = whole;
      flip(damaged, bit);
      put_bytes(file, damaged);
      const AllNumbers read = read_all(path);
      CAPTURE(file.string(), bit);
      require_nothing_wrong(read, written);
      if (file == path) {
        REQUIRE(read.empty());  // the index says so before HDF5 reads it
      }
    }
    put_bytes(file, whole);
  }
}

TEST_CASE("a damaged number costs its own frame, which is named; merge and verify say the same") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  write_series(path, 4);
  FrameReader reader(path);
  const std::size_t temperature = reader.column_of("temperature");
  const Index address = reader.index().addresses[0][temperature];
  std::string bytes = bytes_of(data_path(path, 0));
  flip(bytes, 8 * static_cast<std::size_t>(address + (2 * points + 1) * 8));
  put_bytes(data_path(path, 0), bytes);
  const std::string named = "run.vtkhdf.data' is damaged: temperature of frame 2";
  FrameReader damaged(path);
  REQUIRE_THROWS_WITH(damaged.read(temperature, 2), Catch::Contains(named));
  REQUIRE_NOTHROW(damaged.read(temperature, 1));
  REQUIRE_NOTHROW(damaged.read(damaged.column_of("velocity"), 2));
  const Verification found = verify(path);
  REQUIRE(found.whole_frames == frames - 1);
  REQUIRE(found.damages.size() == 1);
  REQUIRE_THAT(found.damages[0], Catch::Contains(named));
  REQUIRE_THROWS_WITH(merge(path, folder / "merged.vtkhdf"), Catch::Contains(named));
  REQUIRE_FALSE(std::filesystem::exists(folder / "merged.vtkhdf"));
}

TEST_CASE("a merged file is checked like the run it was made of") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf", merged = folder / "merged.vtkhdf";
  write_series(path, 1);
  merge(path, merged);
  REQUIRE(read_all(merged) == read_all(path));
  const std::string whole = bytes_of(merged);
  const AllNumbers written = read_all(merged);
  for (std::size_t bit = 5; bit < 8 * whole.size(); bit += 2003) {
    std::string damaged = whole;
    flip(damaged, bit);
    put_bytes(merged, damaged);
    CAPTURE(bit);
    require_nothing_wrong(read_all(merged), written);
  }
}

TEST_CASE("files that are missing, cut or renamed are named with the way out") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf", data = data_path(path, 0);
  write_series(path, 4);
  SECTION("the data file is gone") {
    std::filesystem::remove(data);
    FrameReader reader(path);
    REQUIRE_THROWS_WITH(reader.read(0, 0), Catch::Contains("run.vtkhdf.data' is missing") &&
                                               Catch::Contains("lapilli merge"));
  }
  SECTION("the index has another name, the data file not: it is found") {
    std::filesystem::rename(path, folder / "new.vtkhdf");
    REQUIRE(FrameReader(folder / "new.vtkhdf").read(0, 3).size() == 3 * points);
    REQUIRE_THROWS_WITH(VtkhdfWriter::resume(folder / "new.vtkhdf", 2), Catch::Contains("renamed"));
  }
  SECTION("cut anywhere") {
    const AllNumbers written = read_all(path);
    for (const auto& file : {path, data}) {
      const std::string whole = bytes_of(file);
      for (std::size_t size = 0; size < whole.size(); size += 509) {
        put_bytes(file, whole.substr(0, size));
        require_nothing_wrong(read_all(path), written);
      }
      put_bytes(file, whole);
    }
  }
}

TEST_CASE("a lost index is made anew from the data files") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  write_series(path, GENERATE(4, 1, 64));
  const std::string index = bytes_of(path);
  const auto change = GENERATE(0, 1);
  if (change == 0) {
    std::filesystem::remove(path);
  } else {
    put_bytes(path, index.substr(0, index.size() / 2));
  }
  REQUIRE(rebuild_index(path) == frames);
  REQUIRE(bytes_of(path) == index);
}

TEST_CASE("frames that a resume took away do not come back with a new index") {
  const ScratchFolder folder;
  const auto path = folder / "run.vtkhdf";
  write_series(path, 8);
  { const VtkhdfWriter writer = VtkhdfWriter::resume(path, 2); }
  std::filesystem::remove(path);
  REQUIRE(rebuild_index(path) == 2);
}

TEST_CASE("a resume takes the newest good checkpoint, makes a lost index anew and says so") {
  const ScratchFolder folder;
  const auto whole = folder / "whole.vtkhdf", output = folder / "run.vtkhdf";
  RunOptions options;
  options.frame_interval = 0.1;
  options.scene_text = "[time]\n";
  options.output = whole;
  Simulation undisturbed = made_simulation(0.8);
  run(undisturbed, options);
  options.output = output;
  Simulation first = made_simulation(0.8);
  int steps = 0;
  options.interrupted = [&] { return ++steps == 11; };
  run(first, options);
  options.interrupted = {};
  options.resume = true;
  const auto newest = checkpoint_paths(output)[0];
  std::string bytes = bytes_of(newest);
  flip(bytes, 4 * bytes.size());
  put_bytes(newest, bytes);
  std::filesystem::remove(output);
  Simulation second = made_simulation(0.8);
  const RunSummary summary = run(second, options);
  REQUIRE(summary.status == RunStatus::finished);
  REQUIRE(summary.notes.size() == 2);
  REQUIRE_THAT(summary.notes[0].text, Catch::Contains("checkpoint before the last"));
  REQUIRE_THAT(summary.notes[1].text, Catch::Contains("made anew"));
  REQUIRE(read_all(output) == read_all(whole));
  REQUIRE_THAT(bytes_of(folder / "run.json"), Catch::Contains("made anew"));
}

TEST_CASE("a checkpoint of another scene is named key by key") {
  const ScratchFolder folder;
  RunOptions options;
  options.output = folder / "run.vtkhdf";
  options.fingerprint = "one";
  options.identity = "grid.cell\t0.1\nheat.theta\t1\n";
  Simulation first = made_simulation(0.3);
  run(first, options);
  options.resume = true;
  options.fingerprint = "two";
  options.identity = "grid.cell\t0.05\nheat.theta\t1\ntime.step\t2\n";
  Simulation second = made_simulation(0.3);
  REQUIRE_THROWS_WITH(run(second, options),
                      Catch::Contains("grid.cell was 0.1 and is 0.05; time.step is new: 2"));
}
