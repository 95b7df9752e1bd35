#include <catch2/catch.hpp>
#include <limits>

#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/checksum.hpp"
#include "lapilli/output/output_error.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

namespace {

Checkpoint made_checkpoint() {
  Checkpoint checkpoint{fingerprint("[grid]\ncell = 0.1\n"), {}};
  checkpoint.state.write("clock/time", 0.1);
  checkpoint.state.write("points/id", std::vector<Index>{3, -1, std::numeric_limits<Index>::max()});
  checkpoint.state.write(
      "heat/temperature",
      std::vector<double>{-0.0, 5e-324, std::numeric_limits<double>::infinity(), 1.0 / 3.0});
  checkpoint.state.write("heat/empty", std::vector<double>{});
  checkpoint.state.write("note", std::string("nine char"));
  return checkpoint;
}

}  // namespace

TEST_CASE("a checkpoint comes back bit by bit") {
  const ScratchFolder folder;
  save_checkpoint(folder / "run.checkpoint", made_checkpoint());
  const Checkpoint back = load_checkpoint(folder / "run.checkpoint");
  REQUIRE(back.fingerprint == made_checkpoint().fingerprint);
  REQUIRE(back.state.arrays() == made_checkpoint().state.arrays());
  save_checkpoint(folder / "again.checkpoint", back);  // tells -0.0 from 0.0
  REQUIRE(bytes_of(folder / "again.checkpoint") == bytes_of(folder / "run.checkpoint"));
}

TEST_CASE("a checkpoint cut anywhere is refused") {
  const ScratchFolder folder;
  const auto path = folder / "run.checkpoint";
  save_checkpoint(path, made_checkpoint());
  const std::string whole = bytes_of(path);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    put_bytes(path, whole.substr(0, size));
    REQUIRE_THROWS_WITH(load_checkpoint(path), Catch::Contains("run.checkpoint"));
  }
  put_bytes(path, whole.substr(0, whole.size() - 8));
  REQUIRE_THROWS_WITH(load_checkpoint(path), Catch::Contains("cut short"));
  put_bytes(path, whole + "more");
  REQUIRE_THROWS_AS(load_checkpoint(path), std::invalid_argument);
}

TEST_CASE("a checkpoint with any one bit flipped is refused") {
  const ScratchFolder folder;
  const auto path = folder / "run.checkpoint";
  save_checkpoint(path, made_checkpoint());
  const std::string whole = bytes_of(path);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    put_bytes(path, damaged);
    REQUIRE_THROWS_AS(load_checkpoint(path), std::invalid_argument);
  }
}

TEST_CASE("checkpoint files of others, missing ones and folders are named with the reason") {
  const ScratchFolder folder;
  put_bytes(folder / "foreign", std::string(1000, 'x'));
  REQUIRE_THROWS_WITH(load_checkpoint(folder / "foreign"),
                      Catch::Contains("foreign") && Catch::Contains("not a checkpoint"));
  REQUIRE_THROWS_WITH(load_checkpoint(folder / "missing"),
                      Catch::Contains("missing") && Catch::Contains("No such file"));
  REQUIRE_THROWS_WITH(load_checkpoint(folder / ""), Catch::Contains("directory"));
}

TEST_CASE("a checkpoint of another scene is refused") {
  const Checkpoint checkpoint = made_checkpoint();
  REQUIRE_NOTHROW(require_same_scene(checkpoint, fingerprint("[grid]\ncell = 0.1\n"), "", "run"));
  REQUIRE_THROWS_WITH(
      require_same_scene(checkpoint, fingerprint("[grid]\ncell = 0.2\n"), "", "run"),
      Catch::Contains("another scene"));
}

TEST_CASE("fingerprints tell texts apart that differ by a zero byte or its length") {
  using namespace std::string_literals;
  REQUIRE(fingerprint("a"s) != fingerprint("a\0"s));
  REQUIRE(fingerprint("") != fingerprint("\0"s));
  REQUIRE(fingerprint("scene").size() == 16);
}
