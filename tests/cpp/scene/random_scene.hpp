#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "lapilli/scene/member_types.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Fills described structs with random values that their keys allow.
class RandomMembers {
 public:
  explicit RandomMembers(std::uint64_t seed) : generator_(seed) {}

  template <class T>
  void fill(const Key& key, T& member, int depth = 0) {
    if constexpr (std::is_same_v<T, bool>) {
      member = chance(0.5);
    } else if constexpr (std::is_same_v<T, double>) {
      member = number(key);
    } else if constexpr (std::is_integral_v<T>) {
      const double most = std::min(key.most, 1e6), least = std::max(key.least, -1e6);
      member = static_cast<T>(least + std::floor(uniform() * (most - least)));
    } else if constexpr (std::is_same_v<T, std::string>) {
      member = text();
    } else if constexpr (std::is_same_v<T, Value>) {
      member = value(key);
    } else if constexpr (std::is_same_v<T, SymmetricTensor>) {
      member = SymmetricTensor(number(key));
      member[3] = chance(0.5) ? 0.0 : number(key);
    } else if constexpr (is_over_temperature<T>) {
      typename T::constant_type constant{};
      fill(key, constant, depth);
      member = constant;
      if (chance(0.5)) {
        TemperatureTable table;
        double at = number(Key("temperatures"));
        const std::size_t entries = 1 + below(4);
        for (std::size_t k = 0; k < entries && std::isfinite(at); ++k) {
          table.temperatures.push_back(at);
          table.values.push_back(number(key));
          at += std::max(1.0, std::abs(at));
        }
        member = std::move(table);
      }
    } else if constexpr (std::is_same_v<T, Overrides>) {
      member.entries.clear();
      const std::size_t count = below(3);
      for (std::size_t k = 1; k <= count; ++k) {  // in the order that files are read in
        member.entries.push_back({message(k, text()), {}, {number(Key("")), {}}});
      }
    } else if constexpr (Named<T>) {
      const auto count = std::size(Names<T>::values);
      member = Names<T>::values[below(count)].first;
    } else if constexpr (std::is_same_v<T, std::optional<GivenPoints>>) {
      member.reset();
    } else if constexpr (is_optional<T>) {
      member.reset();
      if (chance(0.5)) {
        fill(key, member.emplace(), depth);
      }
    } else if constexpr (is_vector<T>) {
      const int most = std::min(key.longest, key.shortest + 3);
      member.resize(static_cast<std::size_t>(key.shortest) +
                    below(static_cast<std::size_t>(most - key.shortest + 1)));
      for (auto& element : member) {
        fill(key, element, depth + 1);
      }
    } else if constexpr (Indirect<T>) {
      Held<T> held;
      fill(key, held, depth + 1);
      member = T(std::move(held));
    } else if constexpr (Kinded<T>) {
      fill_kind(member, depth);
    } else if constexpr (Described<T>) {
      EachMember each{*this, depth};
      T::describe(member, each);
    }
  }

  double uniform() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  bool chance(double share) { return uniform() < share; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(generator_() % count); }

 private:
  struct EachMember {
    RandomMembers& values;
    int depth;
    template <class T>
    void operator()(const Key& key, T& member) {
      values.fill(key, member, depth);
    }
  };

  // Deep trees of shapes end in the first alternatives, which hold no others.
  template <class T>
  void fill_kind(T& member, int depth) {
    constexpr std::size_t count =
        std::variant_size_v<std::remove_cvref_t<decltype(variant_of(member))>>;
    std::size_t choice = below(depth > 3 ? 1 : count);
    for_each_kind<T>([&](auto type) {
      using Alternative = typename decltype(type)::type;
      if (choice-- == 0) {
        if constexpr (std::is_same_v<Alternative, FunctionSolid>) {
          fill_kind(member, depth);  // functions are not written
        } else {
          Alternative alternative{};
          fill(Key(""), alternative, depth + 1);
          variant_of(member) = std::move(alternative);
        }
      }
    });
  }

  double number(const Key& key) {
    if (std::isfinite(key.least) && std::isfinite(key.most)) {
      return key.most - uniform() * (key.most - key.least);
    }
    double size = 0.0;  // any finite bit pattern
    do {
      const std::uint64_t bits = generator_();
      std::memcpy(&size, &bits, sizeof size);
    } while (!std::isfinite(size));
    if (chance(0.3)) {
      size = std::round(100.0 * uniform()) / 10.0;
    }
    return std::isfinite(key.least) ? std::abs(size) + (key.open ? 1e-300 : 0.0) : size;
  }

  Value value(const Key& key) {
    if (chance(0.6)) {
      return number(key);
    }
    Table table;
    for (std::size_t k = 0; k <= below(4); ++k) {
      table.times.push_back(static_cast<double>(k) + uniform());
      table.values.push_back(number(key));
    }
    for (std::size_t k = 1; k < table.times.size(); ++k) {
      table.times[k] = table.times[k - 1] + 0.1 + uniform();
    }
    return table;
  }

  std::string text() {
    static const std::string letters = "aZ0 _\"\\\n\t\r\x01\x7f#[]{}=.,'\xc3\xa9";
    std::string result;
    for (std::size_t k = below(12); k > 0; --k) {
      const char letter = letters[below(letters.size() - 2)];
      result += letter;
    }
    return chance(0.2) ? result + "\xc3\xa9" : result;
  }

  std::mt19937_64 generator_;
};

/// A scene of random values, each of which its key allows; it need not make sense as a whole.
inline Scene random_scene(std::uint64_t seed) {
  Scene scene;
  RandomMembers(seed).fill(Key(""), scene);
  return scene;
}

}  // namespace lapilli
