#include "lapilli/mpm/quasi_static/load_steps.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {
namespace {

/// Times nearer than this are one, s.
double slack(double time, double size) { return std::max(1e-6 * size, 1e-12 * std::abs(time)); }

}  // namespace

LoadSteps::LoadSteps(const QuasiStaticSettings& settings) {
  const auto add = [&](const std::vector<Value>& values) {
    for (const Value& value : values) {
      laws_.push_back(&value);
    }
  };
  add(settings.gravity);
  add(settings.body_force);
  for (const SupportSettings& wall : settings.supports) {
    add(wall.displacement);
    laws_.push_back(&wall.advance);
  }
  for (const TractionSettings& traction : settings.tractions) {
    add(traction.traction);
    laws_.push_back(&traction.pressure);
  }
}

double LoadSteps::whole(double time, double size) const {
  return whole_ > time + 0.5 * slack(time, size) ? std::min(whole_, time + size) : time + size;
}

double LoadSteps::end(double time, double size) const {
  const double near = slack(time, size), last = whole(time, size);
  double next = std::numeric_limits<double>::infinity();
  for (const Value* law : laws_) {
    next = std::min(
        {next, law->next_entry(time + 0.5 * near), law->next_jump(time + 1.5 * near) - near});
  }
  return next < last - 0.5 * near ? next : last;
}

void LoadSteps::save(Archive& archive) const { archive.write("quasi_static/whole_step", whole_); }

void LoadSteps::load(const Archive& archive) {
  whole_ = archive.read_number("quasi_static/whole_step");
}

double length_to(double end, double time) {
  double length = end - time;
  while (time + length < end) {
    length = std::nextafter(length, std::numeric_limits<double>::infinity());
  }
  return length;
}

}  // namespace lapilli
