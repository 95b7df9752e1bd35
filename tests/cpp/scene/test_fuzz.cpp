#include <catch2/catch.hpp>

#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/validate.hpp"
#include "scene/example_scenes.hpp"
#include "scene/random_scene.hpp"

using namespace lapilli;

namespace {

// Fragments that scene files are made of, and some that break readers.
const std::vector<std::string> fragments = {"[",
                                            "]",
                                            "{",
                                            "}",
                                            "[[",
                                            "]]",
                                            "=",
                                            "\"",
                                            "'''",
                                            "\"\"\"",
                                            "\n",
                                            ",",
                                            ".",
                                            "#",
                                            "\\",
                                            "\\u",
                                            "\\x",
                                            "\xff",
                                            "nan",
                                            "inf",
                                            "-inf",
                                            "-0.0",
                                            "1e999",
                                            "1e-999",
                                            "-1",
                                            "0",
                                            "0x7f",
                                            "true",
                                            "kind",
                                            "times",
                                            "values",
                                            "1979-05-27",
                                            "07:32:00",
                                            "\r\n",
                                            std::string(1, '\0'),
                                            "9223372036854775807",
                                            "9223372036854775808",
                                            "-9223372036854775808",
                                            "\xef\xbb\xbf",
                                            "[heat]",
                                            "[[bodies]]",
                                            "[grid]",
                                            "[bodies]",
                                            "shape = {kind = \"union\", shapes = [",
                                            "kind = \"rotated\", shape = {",
                                            "region",
                                            "cell = ",
                                            "points_per_cell = ",
                                            "\xc3\xa9"};

std::string mutated(std::string text, RandomMembers& random) {
  for (std::size_t change = 1 + random.below(4); change > 0 && !text.empty(); --change) {
    const std::size_t at = random.below(text.size()), length = random.below(24);
    switch (random.below(9)) {
      case 0:
        text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, fragments[random.below(fragments.size())]);
        break;
      case 3:
        text.replace(at, length, fragments[random.below(fragments.size())]);
        break;
      case 4:
        text.insert(random.below(text.size()), text.substr(at, length));
        break;
      case 5: {
        const std::string& word = fragments[random.below(fragments.size())];
        for (std::size_t k = random.below(400); k > 0; --k) {
          text.insert(at, word);
        }
        break;
      }
      case 6:
        text.resize(at);
        break;
      default:  // another digit: files that mostly still are scenes
        if (const std::size_t digit = text.find_first_of("0123456789", at);
            digit != std::string::npos) {
          text[digit] = "0123456789.-"[random.below(12)];
        }
    }
  }
  return text;
}

struct Outcome {
  int scenes = 0, usable = 0, refused = 0;
};

// A scene or a std::invalid_argument with its place; anything else fails the test or ends it.
void read_mutated(const std::string& text, Outcome& outcome) {
  try {
    const Scene scene = parse_scene(text, "fuzz.toml");
    ++outcome.scenes;
    REQUIRE_NOTHROW(parse_scene(to_toml(scene), "again.toml"));
    validate(scene);
    ++outcome.usable;
  } catch (const std::invalid_argument& error) {
    ++outcome.refused;
    const std::string message = error.what();
    if (!message.starts_with("fuzz.toml:")) {
      CAPTURE(text, message);
      FAIL("a message without its place");
    }
  }
}

Outcome read_many(int files, std::uint64_t seed) {
  RandomMembers random(seed);
  Outcome outcome;
  for (int k = 0; k < files; ++k) {
    const std::string seed_text =
        random.chance(0.5) ? ring_scene : to_toml(random_scene(random.below(50)));
    read_mutated(mutated(seed_text, random), outcome);
  }
  return outcome;
}

}  // namespace

TEST_CASE("3,000 mutated files are read or refused with their place") {
  const Outcome outcome = read_many(3000, 20260101);
  // Both sides must have been reached, or the mutations test nothing.
  CHECK(outcome.scenes > 30);
  CHECK(outcome.usable > 10);
  CHECK(outcome.refused > 1000);
}

TEST_CASE("100,000 mutated files are read or refused with their place", "[.slow]") {
  const Outcome outcome = read_many(100000, 7);
  CHECK(outcome.scenes > 1000);
  CHECK(outcome.refused > 30000);
}
