// A boundary condition of heat of which one part can be left out: -DLEAVE_OUT=<part>. Compiled by
// the tests only to see what the compiler says.
#include "lapilli/mpm/heat/conditions/condition_parts.hpp"

namespace lapilli {

#define NAMES 1
#define SETTINGS 2
#define REGION 3
#define HOLDING 4
#define ABSOLUTE 5
#define SURROUNDINGS 6
#define COEFFICIENT 7
#define LINEARITY 8
#define EXCHANGE 9

struct Sample {
  static constexpr const char* kind = "sample";
#if LEAVE_OUT != NAMES
  static constexpr const char* modelled = "samples";
#endif
#if LEAVE_OUT != SETTINGS
  template <class Self, class Visitor>
  static void describe(Self&, Visitor&) {}
#endif
  std::string name;
#if LEAVE_OUT != REGION
  std::optional<Shape> region;
#endif
#if LEAVE_OUT != HOLDING
  static constexpr bool holds_temperature = false;
#endif
#if LEAVE_OUT != ABSOLUTE
  static constexpr bool needs_absolute = false;
#endif
#if LEAVE_OUT != SURROUNDINGS
  const Value* surroundings() const { return nullptr; }
#endif
#if LEAVE_OUT != COEFFICIENT
  double largest_coefficient(double, double) const { return 0.0; }
#endif
  const Value* given_coefficient() const { return nullptr; }
#if LEAVE_OUT != LINEARITY
  bool is_linear() const { return true; }
#endif
#if LEAVE_OUT != EXCHANGE
  void find_exchange(const ExchangeSites&, const Exchange&) const {}
#endif
};

static_assert(is_whole_condition<Sample>());

}  // namespace lapilli
