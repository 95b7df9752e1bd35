#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/filled_sums.hpp"
#include "geometry/random_points.hpp"
#include "geometry/scratch_file.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/geometry/sources.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

namespace {

ImageMask of_values(std::vector<std::vector<double>> values, double pixel) {
  ImageMask mask;
  mask.values = std::move(values);
  mask.pixel = pixel;
  return mask;
}

// A disk of radius 0.8 drawn on `count` x `count` pixels over [-1, 1]^2.
ImageMask drawn_disk(int count) {
  ImageMask mask;
  mask.pixel = 2.0 / count;
  mask.origin = {-1, -1};
  for (int row = 0; row < count; ++row) {
    mask.values.emplace_back();
    for (int column = 0; column < count; ++column) {
      const double x = (column + 0.5) * mask.pixel - 1, y = (row + 0.5) * mask.pixel - 1;
      mask.values.back().push_back(std::hypot(x, y) < 0.8 ? 1.0 : 0.0);
    }
  }
  return mask;
}

std::string bytes_of(const std::string& digits) {
  std::string bytes;
  for (std::size_t k = 0; k < digits.size(); k += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(k, 2), nullptr, 16));
  }
  return bytes;
}

}  // namespace

TEST_CASE("pixel edges along the axes are exact, the first row is on top") {
  // Bright: the lower left 2 x 1 pixels of 3 x 2.
  const Shape mask = of_values({{0, 0, 0}, {1, 0.6, 0.4}}, 0.5);
  check(mask, 2);
  REQUIRE(distance(mask, Vec3(0.5, 0.25, 0)) == Approx(-0.25));
  REQUIRE(distance(mask, Vec3(0.5, 0.5, 0)) == Approx(0).margin(1e-15));
  REQUIRE(distance(mask, Vec3(1.0, 0.25, 0)) == Approx(0).margin(1e-15));
  REQUIRE(distance(mask, Vec3(0.5, 0.0, 0)) == Approx(0).margin(1e-15));
  REQUIRE(covers(mask, Vec3(0.1, 0.25, 0)));
  REQUIRE_FALSE(covers(mask, Vec3(0.1, 0.75, 0)));
  REQUIRE(bounds(mask).lower.head<2>() == Vec<2>(0, 0));
  REQUIRE(bounds(mask).upper.head<2>() == Vec<2>(1.0, 0.5));
  REQUIRE((gradient(mask, Vec3(0.5, 0.5, 0)) - Vec3(0, 1, 0)).norm() < 1e-12);
}

TEST_CASE("the distance of a drawn disk is right within a pixel, near and far") {
  for (int count : {40, 80, 160}) {
    const Shape mask = drawn_disk(count);
    check(mask, 2);
    double largest = 0.0, far = 0.0;
    for (const Vec3& x : random_points(2000, 2, {Vec3(-1, -1, 0), Vec3(1, 1, 0)})) {
      largest = std::max(largest, std::abs(distance(mask, x) - (x.norm() - 0.8)));
    }
    REQUIRE(largest < 2.0 / count);
    for (const Vec3& x : random_points(500, 2, {Vec3(-5, -5, 0), Vec3(5, 5, 0)})) {
      far = std::max(far, distance(mask, x) - (x.norm() - 0.8));
    }
    REQUIRE(far < 2.0 / count);  // never more than the truth by over a pixel
  }
}

TEST_CASE("the distance is that to the edges of upright pixels, inside and out, near and far") {
  // Pixels of an L and of strips one pixel wide.
  const ImageMask mask = of_values({{1, 0, 0, 0, 1}, {1, 0, 0, 0, 1}, {1, 1, 1, 0, 1}}, 0.5);
  mask.check(2);
  const auto of_box = [](const Vec3& x, double left, double bottom, double right, double top) {
    const double beside = std::max(left - x[0], x[0] - right);
    const double above = std::max(bottom - x[1], x[1] - top);
    return std::max(beside, above) < 0.0 ? std::max(beside, above)
                                         : std::hypot(std::max(beside, 0.0), std::max(above, 0.0));
  };
  for (const Vec3& x : random_points(3000, 2, {Vec3(-9, -9, 0), Vec3(12, 12, 0)})) {
    const double outside =
        std::min({of_box(x, 0, 0, 0.5, 1.5), of_box(x, 0, 0, 1.5, 0.5), of_box(x, 2, 0, 2.5, 1.5)});
    if (outside > 0.0) {
      REQUIRE(mask.distance(x) == Approx(outside).epsilon(1e-12));
    }
  }
  for (const Vec3& x : random_points(300, 2, {Vec3(2, 0, 0), Vec3(2.5, 1.5, 0)})) {
    REQUIRE(mask.distance(x) == Approx(of_box(x, 2, 0, 2.5, 1.5)).margin(1e-12));
  }
}

TEST_CASE("the distance of any pixels changes by the way walked, and is negative in set ones") {
  Random random(5);
  std::vector<std::vector<double>> values(13, std::vector<double>(17));
  for (auto& row : values) {
    for (double& value : row) {
      value = random.uniform() < 0.5;
    }
  }
  const ImageMask mask = of_values(values, 1.0);
  mask.check(2);
  for (int row = 0; row < 13; ++row) {
    for (int column = 0; column < 17; ++column) {
      const double there = mask.distance(Vec3(column + 0.5, row + 0.5, 0));
      REQUIRE((there < 0.0) == (values[12 - row][column] > 0.5));
    }
  }
  for (const Vec3& x : random_points(3000, 2, {Vec3(-5, -5, 0), Vec3(22, 18, 0)})) {
    const double here = mask.distance(x);
    const Vec3 foot = x - here * mask.gradient(x);
    REQUIRE(std::abs(mask.distance(foot)) < 1e-9);
    REQUIRE(mask.gradient(x).norm() == Approx(1.0));
    const Vec3 other = x + random.uniform() * Vec3(0.3, -0.4, 0);
    REQUIRE(std::abs(mask.distance(other) - here) <= (other - x).norm() + 1e-12);
  }
}

TEST_CASE("image files of every form give the same brightness") {
  const ScratchFile p2("P2 # grey\n3 2\n# most\n4\n0 1 2\n3 4 0\n");
  const ScratchFile p5(std::string("P5 3 2 4\n") + std::string("\0\1\2\3\4\0", 6));
  const ScratchFile p5_wide(std::string("P5\n3 2\n400\n") +
                            std::string("\0\0\0\144\0\310\1\54\1\220\0\0", 12));
  const ScratchFile p3("P3 3 2 4  0 0 0  1 1 1  2 0 4  3 3 3  4 4 4  0 0 0");
  const ScratchFile p6(std::string("P6 3 2 4\n") +
                       std::string("\0\0\0\1\1\1\2\0\4\3\3\3\4\4\4\0\0\0", 18));
  for (const ScratchFile* file : {&p2, &p5, &p5_wide, &p3, &p6}) {
    const Image image = read_image(file->path());
    REQUIRE(image.width == 3);
    REQUIRE(image.height == 2);
    REQUIRE(image.brightness == std::vector<double>{0, 0.25, 0.5, 0.75, 1, 0});
  }
  ImageMask mask;
  mask.file = p5.path();
  mask.dark = true;
  mask.check(2);
  REQUIRE(covers(mask, Vec3(0.5, 1.5, 0)));
  REQUIRE_FALSE(covers(mask, Vec3(0.5, 0.5, 0)));
}

TEST_CASE("PNG images of every form give the same brightness") {
  // 3 x 2 pixels of brightness 0, .2, .4 over .6, .8, 1.
  const std::vector<std::string> images = {
      // 8 bits
      "89504e470d0a1a0a0000000d4948445200000003000000020800000000b81f39c6000000104944415478"
      "da6360304e639879e63f00079a02fe07b350570000000049454e44ae426082",
      // 16 bits
      "89504e470d0a1a0a0000000d4948445200000003000000021000000000e88fe585000000164944415478"
      "da63606030364e4b639839f3cc99ffff011a2705fb9b545d6e0000000049454e44ae426082",
      // colours
      "89504e470d0a1a0a0000000d49484452000000030000000208020000001216f14d0000001b4944415478"
      "da636060603066480302869933679e3973e6ffffff00377608f8808b921e0000000049454e44ae426082",
      // half transparent black, fully transparent
      "89504e470d0a1a0a0000000d49484452000000030000000208060000009d74661a000000224944415478"
      "da63606060f86f6c6cfc1f48cf64983973e6ff3367cefc6767676700006eea0973bfc492400000000049"
      "454e44ae426082",
      // palette of 4 bits
      "89504e470d0a1a0a0000000d49484452000000030000000204030000006f5a7b2900000012504c544500"
      "0000333333666666999999ccccccffffffa94117c90000000e4944415478da6360546030090000014300"
      "a6c3a5112b0000000049454e44ae426082",
  };
  for (const std::string& digits : images) {
    const std::string bytes = bytes_of(digits);
    const ScratchFile file(bytes, ".png");
    const Image image = read_image(file.path());
    REQUIRE(image.width == 3);
    REQUIRE(image.height == 2);
    for (int k = 0; k < 6; ++k) {
      REQUIRE(image.brightness[k] == Approx(0.2 * k).margin(1e-12));
    }
    for (std::size_t length = 9; length < bytes.size() - 12; length += 7) {
      const ScratchFile cut(bytes.substr(0, length), ".png");
      REQUIRE_THROWS_WITH(read_image(cut.path()), Contains("broken PNG image: cut short"));
    }
  }
}

TEST_CASE("set pixels become points, alone or in blocks") {
  ImageMask mask = drawn_disk(40);
  const auto single = points_of_image(mask, 1);
  REQUIRE(single.volume.front() == Approx(0.0025));
  // Pixels are in or out: the 100 on the rim err at random, by 0.3 pixels each, of 804.
  REQUIRE(total(single) == Approx(0.64 * std::numbers::pi).epsilon(1.5e-2));
  const auto blocks = points_of_image(mask, 3);
  REQUIRE(total(blocks) == Approx(total(single)).epsilon(1e-13));
  REQUIRE(blocks.spacing == Approx(0.15));
  REQUIRE(blocks.size() < single.size() / 7);
  double moment = 0.0;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    moment += blocks.volume[k] * blocks.position[2 * k];
  }
  REQUIRE(std::abs(moment) < 1e-14);
  REQUIRE_THROWS_WITH(points_of_image(mask, 0), Contains("at least 1, got 0"));
}

TEST_CASE("an image is filled and clipped like another shape") {
  FillOptions options;
  options.clip = true;
  const auto points = fill(drawn_disk(160), {Vec3(-1, -1, 0), 0.2, 2}, options, 2);
  // Drawn with pixels of 1/80: the area errs by far less than a pixel along the rim.
  REQUIRE(total(points) == Approx(0.64 * std::numbers::pi).epsilon(5e-3));
}

TEST_CASE("unusable images are refused") {
  const auto refused = [](const ImageMask& mask, const std::string& text) {
    REQUIRE_THROWS_WITH(check(mask, 2), Contains(text));
  };
  refused(of_values({{1, 0}, {1}}, 1), "row 0 has 2, row 1 has 1");
  refused(of_values({{0, 0}}, 1), "no pixel is at or above the threshold 0.5");
  refused(of_values({{1}}, -1), "pixel must be positive and finite, got -1");
  refused({}, "image: give a file or values");
  refused(of_values({{0, 255}}, 1),
          "brightness must be 0 to 1, got 255 in row 0, column 1; divide values of 8 bits by 255");
  ImageMask mask = of_values({{1}}, 1);
  mask.threshold = 2;
  refused(mask, "threshold must be 0 to 1, got 2");
  mask = of_values({{1}}, 1);
  mask.dark = true;
  refused(mask, "no pixel is below the threshold");
  mask.file = "x.pgm";
  refused(mask, "not both");
  REQUIRE_THROWS_WITH(check(of_values({{1}}, 1), 1), Contains("image needs a grid of 2 or 3"));
  REQUIRE_THROWS_WITH(of_values({{1}}, 1).bounds(), Contains("before it was checked"));

  const auto broken = [](const std::string& bytes, const std::string& text) {
    const ScratchFile file(bytes);
    REQUIRE_THROWS_WITH(read_image(file.path()), Contains(text) && Contains(file.path()));
  };
  broken("PNG", "not a PNG, PGM or PPM image");
  broken("P5 3", "the height is missing");
  broken("P5 3 0 4", "the height must be 1 to 100000, got 0");
  broken("P5 3 2 70000 ", "the largest value must be 1 to 65535, got 70000");
  broken("P5 3 2 4\nabc", "3 x 2 pixels need 6 bytes, 3 are left");
  broken("P5 1 1 4\na", "above the largest value 4: 97");
  broken("P2 2 1 4 1", "a sample is missing");
  broken("P2 2 1 4 1 5", "a sample must be 0 to 4, got 5");
}
