// A solid of which one part can be left out: -DLEAVE_OUT=<part>. Compiled by the tests only to see
// what the compiler says.
#include "lapilli/materials/solid_parts.hpp"

namespace lapilli {

#define KIND 1
#define PARAMETERS 2
#define CHECK 3
#define ELASTIC_PART 4
#define STATE_VARIABLES 5
#define RETURN 6
#define TANGENT 7
#define PARTING_STRESS 8
#define LAW 9

struct Sample {
#if LEAVE_OUT != KIND
  static constexpr const char* kind = "sample";
#endif
#if LEAVE_OUT != PARAMETERS
  template <class Self, class Visitor>
  static void describe(Self&, Visitor&) {}
#endif
#if LEAVE_OUT != ELASTIC_PART
  const LinearElastic& elastic_part() const { return elastic; }
#endif
#if LEAVE_OUT != STATE_VARIABLES
  std::vector<StateVariable> state_variables() const { return {}; }
#endif
  struct Law {
    explicit Law(const Sample&) {}
#if LEAVE_OUT != LAW
    static constexpr int states = 0;
#endif
    static constexpr bool yields = true, parts = true;
#if LEAVE_OUT != RETURN
    template <class Real, int components>
    void return_stress(Real (&)[components], Real*) const {}
#endif
#if LEAVE_OUT != TANGENT
    SymmetricTensor stress_and_slope(const SymmetricTensor& trial, double*, StressSlope&) const {
      return trial;
    }
#endif
#if LEAVE_OUT != PARTING_STRESS
    double parts_at(const auto*) const { return 0.0; }
#endif
  };
  LinearElastic elastic;
};

#if LEAVE_OUT != CHECK
void check(const Sample&) {}
#endif

static_assert(is_whole_solid<Sample>());

}  // namespace lapilli
