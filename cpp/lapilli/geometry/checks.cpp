#include "lapilli/geometry/checks.hpp"

namespace lapilli {

std::ostream& operator<<(std::ostream& out, const NumbersText& text) {
  out << "(";
  for (std::size_t k = 0; k < text.numbers_.size(); ++k) {
    out << (k == 0 ? "" : ", ") << text.numbers_[k];
  }
  return out << ")";
}

void require_numbers(const std::vector<double>& numbers, std::size_t least, std::size_t most,
                     const char* shape, const char* member) {
  if (numbers.size() < least || numbers.size() > most) {
    const std::string allowed =
        least == most ? message(least) : message(least, most == least + 1 ? " or " : " to ", most);
    require(false, shape, ": ", member, " needs ", allowed, most == 1 ? " number" : " numbers",
            ", got ", numbers.size(), ": ", text_of(numbers));
  }
  for (double number : numbers) {
    require(std::isfinite(number), shape, ": ", member, " must be finite, got ", text_of(numbers));
  }
}

void require_row(const std::vector<double>& numbers, std::size_t count, const char* shape,
                 const char* member, std::size_t row) {
  bool usable = numbers.size() == count;
  for (double number : numbers) {
    usable &= std::isfinite(number);
  }
  if (!usable) {
    require_numbers(numbers, count, count, shape, message(member, " ", row).c_str());
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
