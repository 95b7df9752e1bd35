#include "lapilli/output/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <map>
#include <sstream>

#include "lapilli/core/require.hpp"
#include "lapilli/output/checksum.hpp"
#include "lapilli/output/file.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

using Word = std::uint64_t;

constexpr Word mark = checkpoint_mark;
constexpr Word version = 2;
constexpr std::size_t head_words = 4;  // mark, version, words of content, checksum
enum Kind : Word { numbers, indices, text };

/// Content as words: a text is its length and its bytes filled up to whole words.
class WordWriter {
 public:
  void put(Word word) { words_.push_back(word); }
  void put(const std::string& characters) {
    put(characters.size());
    const std::size_t begin = words_.size();
    words_.resize(begin + (characters.size() + 7) / 8, 0);
    std::memcpy(words_.data() + begin, characters.data(), characters.size());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(values.size());
    for (const T& value : values) {
      put(std::bit_cast<Word>(value));
    }
  }
  const std::vector<Word>& words() const { return words_; }

 private:
  std::vector<Word> words_;
};

/// Reads the same; throws std::invalid_argument rather than pass the end.
class WordReader {
 public:
  explicit WordReader(std::span<const Word> words) : words_(words) {}

  Word word() { return take(1)[0]; }
  std::string characters() {
    const Word size = word();
    const std::span<const Word> from = take(size / 8 + (size % 8 != 0));
    std::string characters(size, '\0');
    std::memcpy(characters.data(), from.data(), size);
    return characters;
  }
  template <class T>
  std::vector<T> values() {
    std::vector<T> values;
    for (const Word word : take(word())) {
      values.push_back(std::bit_cast<T>(word));
    }
    return values;
  }
  bool at_end() const { return words_.empty(); }

 private:
  std::span<const Word> take(Word count) {
    require(count <= words_.size(), "its content is damaged");
    const std::span<const Word> taken = words_.first(count);
    words_ = words_.subspan(count);
    return taken;
  }

  std::span<const Word> words_;
};

struct PutArray {
  WordWriter& to;
  void operator()(const std::vector<double>& values) const { to.put(numbers), to.put(values); }
  void operator()(const std::vector<Index>& values) const { to.put(indices), to.put(values); }
  void operator()(const std::string& characters) const { to.put(text), to.put(characters); }
};

Archive::Array read_array(WordReader& from) {
  switch (from.word()) {
    case numbers:
      return from.values<double>();
    case indices:
      return from.values<Index>();
    case text:
      return from.characters();
    default:
      throw std::invalid_argument("its content is damaged");
  }
}

std::vector<Word> read_words(const File& file) {
  const auto bytes = static_cast<std::size_t>(file.size());
  std::vector<Word> words(bytes / 8);
  file.read_at(0, std::as_writable_bytes(std::span(words)));
  require(words.size() >= 2 && words[0] == mark, "it is not a checkpoint of lapilli");
  require(words[1] == version, "it is of format ", words[1], ", this version reads format ",
          version);
  require(words.size() >= head_words && bytes % 8 == 0 && words[2] == words.size() - head_words,
          "it is cut short: ", bytes, " bytes of ",
          words.size() < 3 ? 8 * head_words : 8 * (head_words + words[2]));
  require(words[3] == checksum_of(std::span(words).subspan(head_words)),
          "it is damaged: its checksum does not fit its content");
  return words;
}

Checkpoint parse(WordReader from) {
  Checkpoint checkpoint;
  checkpoint.fingerprint = from.characters();
  checkpoint.identity = from.characters();
  for (Word left = from.word(); left > 0; --left) {
    const std::string name = from.characters();
    checkpoint.state.insert(name, read_array(from));
  }
  require(from.at_end(), "its content is damaged");
  return checkpoint;
}

std::map<std::string, std::string> settings_of(const std::string& identity) {
  std::map<std::string, std::string> settings;
  std::istringstream lines(identity);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');
    settings[line.substr(0, tab)] = tab == std::string::npos ? "" : line.substr(tab + 1);
  }
  return settings;
}

/// "grid.cell was 0.1 and is 0.05; time.step is new"
std::string differences(const std::string& before, const std::string& now) {
  constexpr int most_named = 8;
  const auto was = settings_of(before), is = settings_of(now);
  std::map<std::string, std::string> keys = was;
  keys.insert(is.begin(), is.end());
  std::string text;
  int count = 0;
  for (const auto& [key, value] : keys) {
    const auto old = was.find(key), given = is.find(key);
    if (old != was.end() && given != is.end() && old->second == given->second) {
      continue;
    }
    if (++count > most_named) {
      return text + "; and more";
    }
    text += (text.empty() ? "" : "; ") + key;
    text += old == was.end()    ? " is new: " + given->second
            : given == is.end() ? " is gone, it was " + old->second
                                : " was " + old->second + " and is " + given->second;
  }
  return text.empty() ? "its settings are not known one by one" : text;
}

bool begins_with(const std::filesystem::path& path, std::span<const Word> head) {
  try {
    std::vector<Word> found(head.size());
    File(path, File::Mode::read).read_at(0, std::as_writable_bytes(std::span(found)));
    return std::equal(head.begin(), head.end(), found.begin());
  } catch (const OutputError&) {
    return false;
  }
}

/// The checkpoint of now becomes the one before, and stays in place until a new one replaces it.
/// One of the same state, as a run resumed at its end writes, is none before.
void keep_as_previous(const std::filesystem::path& path, std::span<const Word> new_head) {
  std::error_code error;
  if (begins_with(path, new_head)) {
    return;
  }
  const std::filesystem::path previous = with_ending(path, ".previous");
  std::filesystem::remove(previous, error);
  std::filesystem::create_hard_link(path, previous, error);
}

}  // namespace

std::array<std::filesystem::path, 2> checkpoint_paths(const std::filesystem::path& output) {
  const auto newest = std::filesystem::path(output).replace_extension(".checkpoint");
  return {newest, with_ending(newest, ".previous")};
}

void save_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  WordWriter content;
  content.put(checkpoint.fingerprint);
  content.put(checkpoint.identity);
  content.put(checkpoint.state.arrays().size());
  for (const auto& [name, array] : checkpoint.state.arrays()) {
    content.put(name);
    std::visit(PutArray{content}, array);
  }
  const std::array<Word, head_words> head = {mark, version, content.words().size(),
                                             checksum_of(content.words())};
  AtomicFile file(path);
  file.append(std::as_bytes(std::span(head)));
  file.append(std::as_bytes(std::span(content.words())));
  keep_as_previous(path, head);
  file.commit();
}

Checkpoint load_checkpoint(const std::filesystem::path& path) {
  const File file(path, File::Mode::read);
  try {
    const std::vector<Word> words = read_words(file);
    return parse(WordReader(std::span(words).subspan(head_words)));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        message("cannot use checkpoint '", path.string(), "': ", error.what()));
  }
}

void require_same_scene(const Checkpoint& checkpoint, const std::string& fingerprint,
                        const std::string& identity, const std::filesystem::path& path) {
  require(checkpoint.fingerprint == fingerprint, "cannot use checkpoint '", path.string(),
          "': it belongs to another scene; ", differences(checkpoint.identity, identity));
}

}  // namespace lapilli
