#include "lapilli/output/file_seal.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"
#include "lapilli/output/checksum.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

using Word = std::uint64_t;

constexpr Word seal_mark = 0x6c6165736c70616c;  // "laplseal" read as one little-endian word
constexpr std::size_t fixed_words = 5;          // size, checksum | own checksum, pieces, seal_mark

}  // namespace

FileSeal FileSeal::of(const Hdf5Image& image, Extent extent) {
  FileSeal seal;
  seal.hdf5_size = image.size;
  if (extent == Extent::whole) {
    seal.pieces.push_back({0, image.size});
  } else {
    for (const auto& [begin, end] : image.written) {
      seal.pieces.push_back({begin, end - begin});
    }
  }
  seal.checksum = seal.sum([&](std::int64_t offset, std::span<std::byte> bytes) {
    image.read(offset, bytes.data(), bytes.size());
  });
  return seal;
}

std::uint64_t FileSeal::sum(const Read& read) const {
  constexpr std::int64_t at_once = 1 << 16;  // bytes, whole words
  Checksum total;
  std::vector<std::byte> bytes;
  for (const Piece& piece : pieces) {
    for (std::int64_t done = 0; done < piece.size; done += at_once) {
      bytes.resize(static_cast<std::size_t>(std::min(at_once, piece.size - done)));
      read(piece.begin + done, bytes);
      total.add(bytes);
    }
  }
  return total.value();
}

void FileSeal::write_to(File& file) const {
  std::vector<Word> words = {static_cast<Word>(hdf5_size), checksum};
  for (const Piece& piece : pieces) {
    words.push_back(static_cast<Word>(piece.begin));
    words.push_back(static_cast<Word>(piece.size));
  }
  words.push_back(pieces.size());
  words.push_back(checksum_of(words));
  words.push_back(seal_mark);
  file.write_at(hdf5_size, std::as_bytes(std::span(words)));
}

std::optional<FileSeal> FileSeal::find(const File& file) {
  constexpr std::int64_t word = sizeof(Word), tail_words = 3;
  const std::int64_t bytes = file.size();
  if (bytes < static_cast<std::int64_t>(fixed_words) * word) {
    return std::nullopt;
  }
  Word tail[tail_words];  // pieces, own checksum, seal_mark
  file.read_at(bytes - tail_words * word, std::as_writable_bytes(std::span(tail)));
  if (tail[2] != seal_mark || tail[0] > static_cast<Word>(bytes / (2 * word))) {
    return std::nullopt;
  }
  std::vector<Word> words(2 * tail[0] + fixed_words);
  const std::int64_t begin = bytes - static_cast<std::int64_t>(words.size()) * word;
  if (begin < 0) {
    return std::nullopt;
  }
  file.read_at(begin, std::as_writable_bytes(std::span(words)));
  if (words[words.size() - 2] != checksum_of(std::span(words).first(words.size() - 2)) ||
      words[0] != static_cast<Word>(begin)) {
    return std::nullopt;
  }
  FileSeal seal{begin, {}, words[1]};
  for (std::size_t k = 2; k + tail_words < words.size(); k += 2) {
    seal.pieces.push_back(
        {static_cast<std::int64_t>(words[k]), static_cast<std::int64_t>(words[k + 1])});
  }
  return seal;
}

bool FileSeal::fits(const File& file) const {
  return checksum ==
         sum([&](std::int64_t offset, std::span<std::byte> bytes) { file.read_at(offset, bytes); });
}

void require_whole(const File& file) {
  const std::string name = file.path().string();
  const std::optional<FileSeal> seal = FileSeal::find(file);
  require(seal.has_value(), "'", name,
          "' holds no frames of lapilli, or is cut short or damaged at its end");
  if (!seal->fits(file)) {
    throw OutputError(
        message("'", name, "' is damaged: what HDF5 laid out does not fit its checksum"));
  }
}

}  // namespace lapilli
