#include "lapilli/geometry/png_file.hpp"

#include <png.h>

#include <csetjmp>
#include <cstring>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr std::size_t signature_bytes = 8;
constexpr png_uint_32 most_pixels = 100'000;  // along each side
constexpr std::size_t most_in_all = 400'000'000;

// What libpng is given and leaves; errors come back by longjmp, over plain data only.
struct Decoding {
  const std::string* bytes;
  std::size_t at = 0;
  char error[128] = "";
  png_structp file = nullptr;
  png_infop info = nullptr;
  png_uint_32 width = 0, height = 0;
  int channels = 0, depth = 0;

  ~Decoding() { png_destroy_read_struct(&file, &info, nullptr); }
};

void read_some(png_structp file, png_bytep to, std::size_t count) {
  auto& all = *static_cast<Decoding*>(png_get_io_ptr(file));
  if (all.bytes->size() - all.at < count) {
    png_error(file, "cut short");
  }
  std::memcpy(to, all.bytes->data() + all.at, count);
  all.at += count;
}

void fail(png_structp file, png_const_charp what) {
  auto& all = *static_cast<Decoding*>(png_get_error_ptr(file));
  std::strncpy(all.error, what, sizeof all.error - 1);
  png_longjmp(file, 1);
}

void ignore(png_structp, png_const_charp) {}

// False after an error.
bool read_header(Decoding& all) {
  if (setjmp(png_jmpbuf(all.file)) != 0) {
    return false;
  }
  png_set_read_fn(all.file, &all, read_some);
  png_set_user_limits(all.file, most_pixels, most_pixels);
  png_read_info(all.file, all.info);
  png_set_expand(all.file);  // palettes, few bits and transparent colours to plain channels
  png_set_interlace_handling(all.file);
  png_read_update_info(all.file, all.info);
  all.width = png_get_image_width(all.file, all.info);
  all.height = png_get_image_height(all.file, all.info);
  all.channels = png_get_channels(all.file, all.info);
  all.depth = png_get_bit_depth(all.file, all.info);
  return true;
}

bool read_rows(Decoding& all, png_bytepp rows) {
  if (setjmp(png_jmpbuf(all.file)) != 0) {
    return false;
  }
  png_read_image(all.file, rows);
  png_read_end(all.file, nullptr);
  return true;
}

// 0 to 1; samples of 16 bits have the more significant byte first.
double sample(const png_byte* at, int depth) {
  return depth == 16 ? (256 * at[0] + at[1]) / 65535.0 : at[0] / 255.0;
}

}  // namespace

bool is_png(const std::string& bytes) {
  return bytes.size() > signature_bytes &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, signature_bytes) == 0;
}

Image png_image(const std::string& bytes, const std::string& path) {
  Decoding all{&bytes};
  all.file = png_create_read_struct(PNG_LIBPNG_VER_STRING, &all, fail, ignore);
  require(all.file != nullptr, path, ": this libpng is not the one that was compiled against");
  all.info = png_create_info_struct(all.file);
  require(all.info != nullptr && read_header(all), path, ": broken PNG image: ", all.error);

  require(std::size_t{all.width} * all.height <= most_in_all, path, ": the image has ", all.width,
          " x ", all.height, " pixels, at most ", most_in_all, " are read");
  const std::size_t stride = png_get_rowbytes(all.file, all.info);
  std::vector<png_byte> pixels(stride * all.height);
  std::vector<png_bytep> rows;
  for (png_uint_32 row = 0; row < all.height; ++row) {
    rows.push_back(pixels.data() + row * stride);
  }
  require(read_rows(all, rows.data()), path, ": broken PNG image: ", all.error);

  Image image;
  image.width = static_cast<int>(all.width);
  image.height = static_cast<int>(all.height);
  image.brightness.reserve(static_cast<std::size_t>(all.width) * all.height);
  const int colours = all.channels > 2 ? 3 : 1, bytes_each = all.depth / 8;
  const bool has_alpha = all.channels % 2 == 0;
  for (const png_byte* row : rows) {
    for (png_uint_32 column = 0; column < all.width; ++column) {
      const png_byte* at = row + column * static_cast<png_uint_32>(all.channels * bytes_each);
      double sum = 0.0;
      for (int colour = 0; colour < colours; ++colour) {
        sum += sample(at + colour * bytes_each, all.depth);
      }
      const double alpha = has_alpha ? sample(at + colours * bytes_each, all.depth) : 1.0;
      image.brightness.push_back(alpha * sum / colours + (1.0 - alpha));
    }
  }
  return image;
}

}  // namespace lapilli
