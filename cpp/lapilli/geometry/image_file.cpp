#include "lapilli/geometry/image_file.hpp"

#include <cctype>
#include <cstdint>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/file_bytes.hpp"
#include "lapilli/geometry/png_file.hpp"

namespace lapilli {
namespace {

class Reader {
 public:
  Reader(const std::string& path, const std::string& bytes) : path_(path), bytes_(bytes) {}

  // A number of the header or of a text image; comments run from # to the end of the line.
  int number(const char* what, int least, int most) {
    while (at_ < bytes_.size() && (std::isspace(next()) || next() == '#')) {
      if (next() == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else {
        ++at_;
      }
    }
    require(at_ < bytes_.size() && std::isdigit(next()), path_, ": ", what, " is missing at byte ",
            at_);
    long long value = 0;
    for (; at_ < bytes_.size() && std::isdigit(next()) && value < 1'000'000'000; ++at_) {
      value = 10 * value + (next() - '0');
    }
    require(value >= least && value <= most, path_, ": ", what, " must be ", least, " to ", most,
            ", got ", value);
    return static_cast<int>(value);
  }

  // One sample of a binary image, the more significant byte first.
  int sample(int most) {
    int value = next();
    ++at_;
    if (most > 255) {
      value = 256 * value + next();
      ++at_;
    }
    require(value <= most, path_, ": a sample at byte ", at_, " is above the largest value ", most,
            ": ", value);
    return value;
  }

  void skip(std::size_t count) { at_ += count; }
  std::size_t left() const { return bytes_.size() - std::min(at_, bytes_.size()); }

 private:
  unsigned char next() const { return static_cast<unsigned char>(bytes_[at_]); }

  const std::string& path_;
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

Image read_image(const std::string& path) {
  const std::string bytes = read_bytes(path);
  if (is_png(bytes)) {
    return png_image(bytes, path);
  }
  const bool known = bytes.size() > 2 && bytes[0] == 'P' &&
                     std::string("2356").find(bytes[1]) != std::string::npos;
  require(known, path,
          ": not a PNG, PGM or PPM image (P2, P3, P5 or P6); convert it to one of these");
  const bool is_text = bytes[1] == '2' || bytes[1] == '3';
  const int channels = bytes[1] == '3' || bytes[1] == '6' ? 3 : 1;
  Reader reader(path, bytes);
  reader.skip(2);
  Image image;
  image.width = reader.number("the width", 1, 100'000);
  image.height = reader.number("the height", 1, 100'000);
  const int most = reader.number("the largest value", 1, 65535);
  const std::size_t pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (!is_text) {
    reader.skip(1);
    const std::size_t needed = pixels * static_cast<std::size_t>(channels) * (most > 255 ? 2 : 1);
    require(reader.left() >= needed, path, ": cut short: ", image.width, " x ", image.height,
            " pixels need ", needed, " bytes, ", reader.left(), " are left");
  }
  for (std::size_t k = 0; k < pixels; ++k) {
    int sum = 0;
    for (int channel = 0; channel < channels; ++channel) {
      sum += is_text ? reader.number("a sample", 0, most) : reader.sample(most);
    }
    image.brightness.push_back(sum / (static_cast<double>(channels) * most));
  }
  return image;
}

}  // namespace lapilli
