#include "lapilli/geometry/checks.hpp"

namespace lapilli {

std::string text_of(const std::vector<double>& numbers) {
  std::string text = "(";
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    text += message(k == 0 ? "" : ", ", numbers[k]);
  }
  return text + ")";
}

std::string text_of(const Vec3& at, int dimension) {
  return text_of(std::vector<double>(at.data(), at.data() + dimension));
}

void require_numbers(const std::vector<double>& numbers, std::size_t least, std::size_t most,
                     const char* shape, const char* member) {
  const std::string allowed =
      least == most ? message(least) : message(least, most == least + 1 ? " or " : " to ", most);
  require(numbers.size() >= least && numbers.size() <= most, shape, ": ", member, " needs ",
          allowed, most == 1 ? " number" : " numbers", ", got ", numbers.size(), ": ",
          text_of(numbers));
  for (double number : numbers) {
    require(std::isfinite(number), shape, ": ", member, " must be finite, got ", text_of(numbers));
  }
}

void require_positive(double value, const char* shape, const char* member) {
  require(std::isfinite(value) && value > 0.0, shape, ": ", member,
          " must be positive and finite, got ", value);
}

void require_dimension(int dimension, int least, const char* shape, const char* instead) {
  require(dimension >= least, shape, " needs a grid of ", least, least == 3 ? "" : " or 3",
          " dimensions, this one has ", dimension, ": use ", instead);
}

}  // namespace lapilli
