#include "lapilli/output/checkpoint.hpp"

#include <algorithm>
#include <array>
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

constexpr std::size_t buffered = 1 << 16;  // words

/// Content as words: a text is its length and its bytes filled up to whole words. What is large
/// goes to the file from where it stands, what is small by the buffer.
class WordWriter {
 public:
  explicit WordWriter(AtomicFile& file) : file_(file) {}

  void put(Word word) { put_words(std::span(&word, 1)); }
  void put(const std::string& characters) {
    put(characters.size());
    std::vector<Word> words((characters.size() + 7) / 8, 0);
    std::memcpy(words.data(), characters.data(), characters.size());
    put_words(words);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    static_assert(sizeof(T) == sizeof(Word));
    put(values.size());
    put_words({reinterpret_cast<const Word*>(values.data()), values.size()});
  }
  /// Write what waits; the sum of all.
  const LongChecksum& finish() {
    flush();
    return sum_;
  }

 private:
  void put_words(std::span<const Word> words) {
    if (words.empty()) {
      return;
    }
    sum_.add(words);
    if (words.size() > buffered) {
      flush();
      file_.append(std::as_bytes(words));
      return;
    }
    waiting_.resize(waiting_.size() + words.size());
    std::memcpy(waiting_.data() + waiting_.size() - words.size(), words.data(), 8 * words.size());
    if (waiting_.size() > buffered) {
      flush();
    }
  }
  void flush() {
    file_.append(std::as_bytes(std::span(waiting_)));
    waiting_.clear();
  }

  AtomicFile& file_;
  LongChecksum sum_;
  std::vector<Word> waiting_;
};

/// Reads the same; throws std::invalid_argument rather than pass the end.
class WordReader {
 public:
  /// From word `begin` of the file to word `end`.
  WordReader(const File& file, Word begin, Word end) : file_(file), at_(begin), end_(end) {}

  Word word() {
    Word word = 0;
    read(std::span(&word, 1));
    return word;
  }
  std::string characters() {
    const Word size = word();
    std::vector<Word> words(checked(size / 8 + (size % 8 != 0)));
    read(words);
    std::string characters(size, '\0');
    std::memcpy(characters.data(), words.data(), size);
    return characters;
  }
  template <class T>
  std::vector<T> values() {
    std::vector<T> values(checked(word()));
    read({reinterpret_cast<Word*>(values.data()), values.size()});
    return values;
  }
  bool at_end() const { return at_ == end_; }
  Word left() const { return end_ - at_; }

  void read(std::span<Word> words) {
    checked(words.size());
    if (words.empty()) {
      return;
    }
    if (words.size() > buffered) {
      file_.read_at(static_cast<std::int64_t>(8 * at_), std::as_writable_bytes(words));
    } else {
      if (at_ < first_ || at_ + words.size() > first_ + ahead_.size()) {
        first_ = at_;
        ahead_.resize(std::min<Word>(buffered, left()));
        file_.read_at(static_cast<std::int64_t>(8 * first_),
                      std::as_writable_bytes(std::span(ahead_)));
      }
      std::memcpy(words.data(), ahead_.data() + (at_ - first_), 8 * words.size());
    }
    at_ += words.size();
  }

 private:
  Word checked(Word count) const {
    require(count <= left(), "its content is damaged");
    return count;
  }

  const File& file_;
  Word at_, end_;
  Word first_ = 0;  // of what is read ahead
  std::vector<Word> ahead_;
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

/// Where the content ends, in words; throws std::invalid_argument unless it is whole.
Word checked_end(const File& file) {
  const auto bytes = static_cast<Word>(file.size());
  std::array<Word, head_words> head{};
  const Word there = std::min<Word>(head_words, bytes / 8);
  file.read_at(0, std::as_writable_bytes(std::span(head).first(there)));
  require(there >= 2 && head[0] == mark, "it is not a checkpoint of lapilli");
  require(head[1] == version, "it is of format ", head[1], ", this version reads format ", version);
  require(there == head_words && bytes % 8 == 0 && head[2] == bytes / 8 - head_words,
          "it is cut short: ", bytes, " bytes of ",
          there < 3 ? 8 * head_words : 8 * (head_words + head[2]));
  LongChecksum sum;
  std::vector<Word> part(buffered);
  for (WordReader from(file, head_words, bytes / 8); !from.at_end();) {
    const std::span<Word> next = std::span(part).first(std::min<Word>(part.size(), from.left()));
    from.read(next);
    sum.add(next);
  }
  require(head[3] == sum.value(), "it is damaged: its checksum does not fit its content");
  return bytes / 8;
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
  AtomicFile file(path);
  std::array<Word, head_words> head = {mark, version, 0, 0};
  file.append(std::as_bytes(std::span(head)));
  WordWriter content(file);
  content.put(checkpoint.fingerprint);
  content.put(checkpoint.identity);
  content.put(checkpoint.state.arrays().size());
  for (const auto& [name, array] : checkpoint.state.arrays()) {
    content.put(name);
    std::visit(PutArray{content}, array);
  }
  const LongChecksum& sum = content.finish();
  head = {mark, version, sum.words(), sum.value()};
  file.file().write_at(0, std::as_bytes(std::span(head)));
  keep_as_previous(path, head);
  file.commit();
}

Checkpoint load_checkpoint(const std::filesystem::path& path) {
  const File file(path, File::Mode::read);
  try {
    return parse(WordReader(file, head_words, checked_end(file)));
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
