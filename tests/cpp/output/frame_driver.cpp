// Writes made frames and a checkpoint after each, saying so line by line, for tests that read the
// files in Python or kill the writer: frame_driver PATH FRAMES POINTS PLANNED [still]

#include <cstdio>
#include <string>

#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"
#include "output/made_frames.hpp"

int main(int count, char** words) {
  using namespace lapilli;
  if (count < 5) {
    return 2;
  }
  const std::filesystem::path path = words[1];
  testing::MadeFrames made(std::stoll(words[3]), count == 5);
  VtkhdfWriter writer(path, std::stoll(words[4]));
  for (Index frame = 0; frame < std::stoll(words[2]); ++frame) {
    made.go_to(frame);
    writer.write(0.5 * static_cast<double>(frame), made.points, made.fields());
    Checkpoint checkpoint{"made", {}};
    checkpoint.state.write("frames", frame + 1);
    made.points.save(checkpoint.state);
    save_checkpoint(path.parent_path() / "run.checkpoint", checkpoint);
    std::printf("%lld\n", static_cast<long long>(frame));
    std::fflush(stdout);
  }
  return 0;
}
