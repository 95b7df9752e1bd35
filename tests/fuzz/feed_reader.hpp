#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "lapilli/geometry/image_file.hpp"
#include "lapilli/geometry/sources.hpp"
#include "lapilli/geometry/stl_file.hpp"
#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/scene/scene_file.hpp"

namespace lapilli::testing {

/// Every reader of files, by the folder of its corpus.
inline constexpr const char* readers[] = {"scene", "stl",   "npy",       "csv",
                                          "image", "index", "checkpoint"};

inline void read_frames(const std::string& path) {
  FrameReader reader(path);
  for (Index frame = 0; frame < reader.index().frames(); ++frame) {
    for (std::size_t column = 0; column < reader.index().columns.size(); ++column) {
      reader.read(column, frame);
    }
  }
}

/// Give a reader the content of a file; the errors it may throw are as good as an answer.
inline void feed(const std::string& reader, const std::string& bytes,
                 const std::filesystem::path& folder) {
  const std::string path = folder / (reader == "npy" ? "fed.npy" : "fed");
  std::ofstream(path, std::ios::binary) << bytes;
  try {
    if (reader == "scene") {
      parse_scene(bytes, path);
    } else if (reader == "stl") {
      read_stl(path);
    } else if (reader == "image") {
      read_image(path);
    } else if (reader == "index") {
      read_frames(path);
    } else if (reader == "checkpoint") {
      load_checkpoint(path);
    } else {
      read_points(path, 2, 1.0);
    }
  } catch (const std::invalid_argument&) {
  } catch (const OutputError&) {
  }
}

}  // namespace lapilli::testing
