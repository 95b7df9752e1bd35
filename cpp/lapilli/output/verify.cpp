#include "lapilli/output/verify.hpp"

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/file_seal.hpp"
#include "lapilli/output/frame_datasets.hpp"
#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"

namespace lapilli {
namespace {

/// Note what `work` throws about files; says whether there was nothing.
template <class Work>
bool is_whole(std::vector<std::string>& damages, const Work& work) {
  try {
    work();
    return true;
  } catch (const OutputError& error) {
    damages.emplace_back(error.what());
  } catch (const std::invalid_argument& error) {
    damages.emplace_back(error.what());
  }
  return false;
}

void verify_frames(FrameReader& reader, Verification& found) {
  const FrameIndex& index = reader.index();
  for (Index frame = 0; frame < index.frames(); ++frame) {
    bool whole = true;
    for (std::size_t column = 0; whole && column < index.columns.size(); ++column) {
      allow_interruption();
      whole = is_whole(found.damages, [&] { reader.read(column, frame); });
    }
    found.whole_frames += whole ? 1 : 0;
  }
}

/// A checkpoint of other frames would go on from them with another state.
void require_of_frames(const Archive& state, const FrameIndex& index) {
  if (!state.contains("run/last_frame") || index.sums.empty()) {
    return;
  }
  const Index frames = state.read_index("run/frames");
  require(frames <= index.frames() &&
              static_cast<Index>(index.sums[static_cast<std::size_t>(frames - 1)]) ==
                  state.read_index("run/last_frame"),
          "the checkpoint is of other frames: frame ", frames - 1,
          " is not the one it goes on from");
}

void verify_beside(const std::filesystem::path& path, const FrameIndex& index,
                   Verification& found) {
  for (std::size_t file = 0; file < index.capacities.size(); ++file) {
    is_whole(found.damages, [&] {
      require_whole(File(data_path(path.parent_path() / index.name, file), File::Mode::read));
    });
  }
  for (const auto& checkpoint : checkpoint_paths(path)) {
    std::error_code ignored;
    if (std::filesystem::exists(checkpoint, ignored)) {
      is_whole(found.damages, [&] { require_of_frames(load_checkpoint(checkpoint).state, index); });
    }
  }
}

/// What a data file says of itself. It must have been found whole before HDF5 reads it.
void add_data_file(const std::filesystem::path& path, FrameIndex& index) {
  require_whole(File(path, File::Mode::read));
  const Hdf5Session session;
  const Hdf5Id file = hdf5_open(path);
  const Hdf5Id own(H5Gopen2(file, "lapilli", H5P_DEFAULT), H5Gclose, "read the data file");
  index.columns = parse_layout(hdf5_read_text_attribute(own, "columns"));
  const std::vector<Index> sizes = hdf5_read_attribute<Index>(own, "points_and_capacity");
  index.points = sizes.at(0);
  read_form(own, index);
  index.capacities.push_back(sizes.at(1));
  Addresses& addresses = index.addresses.emplace_back();
  for (const Column& column : index.columns) {
    addresses.push_back(hdf5_address(file, column.name));
  }
  addresses.push_back(hdf5_address(own, "journal"));
}

void add_frames(const std::vector<FrameData>& data, FrameIndex& index) {
  index.slots.resize(index.columns.size());
  for (Index frame = 0; frame < index.capacity(); ++frame) {
    const auto [file, row] = index.place(frame);
    const std::optional<FrameEntry> entry = data[file].read_entry(row);
    if (!entry || entry->frame != frame) {
      return;
    }
    index.times.push_back(entry->time);
    index.sums.push_back(entry->sum());
    if (entry->points) {
      index.counts.push_back(*entry->points);
    }
    for (std::size_t column = 0; column < index.columns.size(); ++column) {
      index.slots[column].push_back(entry->slots[column]);
    }
  }
}

}  // namespace

Verification verify(const std::filesystem::path& frames) {
  FrameReader reader(frames);
  Verification found;
  found.frames = reader.index().frames();
  verify_frames(reader, found);
  if (!reader.index().merged) {
    verify_beside(frames, reader.index(), found);
  }
  return found;
}

Index rebuild_index(const std::filesystem::path& frames) {
  const RunLock lock(frames);
  return rebuild_index(frames, lock);
}

Index rebuild_index(const std::filesystem::path& frames, const RunLock& /*held*/) {
  FrameIndex index;
  index.name = frames.filename().string();
  std::error_code ignored;
  std::vector<FrameData> data;
  for (std::size_t file = 0; std::filesystem::exists(data_path(frames, file), ignored); ++file) {
    add_data_file(data_path(frames, file), index);
  }
  if (index.capacities.empty()) {
    throw OutputError(message("the index '", frames.string(),
                              "' cannot be made anew: there is no '", data_path(frames, 0).string(),
                              "' beside it"));
  }
  add_frames(open_data(frames, index, File::Mode::read), index);
  if (index.times.empty()) {
    throw OutputError(message("'", data_path(frames, 0).string(), "' holds no whole frame"));
  }
  write_index(frames, index);
  return index.frames();
}

}  // namespace lapilli
