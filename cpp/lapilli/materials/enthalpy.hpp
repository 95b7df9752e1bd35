#pragma once

#include <cstddef>
#include <vector>

#include "lapilli/materials/thermal.hpp"

namespace lapilli {

/// A function of the temperature that rises, as the integral of a positive slope that is linear
/// between some temperatures; it may jump. Outside of the temperatures the slopes go on.
class RisingIntegral {
 public:
  /// Of a constant slope, zero at zero.
  explicit RisingIntegral(double slope = 1.0);
  /// Of a tabulated slope, divided by `unit`; zero at zero.
  RisingIntegral(const TemperatureTable& slope, double unit);

  /// Add a rise by `amount`, evenly over [begin, end], at once where they are equal.
  void add_rise(double begin, double end, double amount);

  /// At a jump the value below it.
  double at(double temperature) const;
  double slope(double temperature) const;
  /// The temperature where the value is reached and its slope there, d temperature/d value; within
  /// a jump its temperature and 0.
  struct Place {
    double temperature, slope;
  };
  Place inverse(double value) const;

 private:
  // From `temperature` and `value` on: value + start s + bend s^2, s the way from there; `rise` is
  // a jump at its temperature, before it.
  struct Segment {
    double temperature, rise, value, start, bend;
  };
  /// The last segment from `temperature` on, or from below it where they are equal; the first where
  /// there is none.
  std::size_t segment_up_to(double temperature) const;
  std::size_t segment_below(double temperature) const;
  void split(double temperature);
  void sum_up();

  double origin_ = 0.0;  // what the segments have at zero
  std::vector<Segment> segments_;
};

/// Volumetric enthalpy of a material, J/m^3: heat stored since absolute zero, melting included.
class Enthalpy {
 public:
  explicit Enthalpy(const Thermal& material);

  /// Of the solid where melting begins, at one temperature.
  double at(double temperature) const { return stored_.at(temperature); }
  RisingIntegral::Place place(double enthalpy) const { return stored_.inverse(enthalpy); }
  /// d enthalpy/dT, J/(m^3 K), outside of a jump.
  double slope(double temperature) const { return stored_.slope(temperature); }
  /// The share that is liquid, from the temperature and, where it melts at once, the enthalpy.
  double liquid_fraction(double temperature, double enthalpy) const;
  bool melts() const { return latent_ > 0.0; }
  /// Heat taken up at once at this temperature, J/m^3.
  double latent_at(double temperature) const {
    return begin_ == end_ && temperature == begin_ ? latent_ : 0.0;
  }

 private:
  RisingIntegral stored_;
  double begin_, end_, latent_;  // K; J/m^3
};

/// Kirchhoff's potential of an isotropic conductivity in kelvin: integral of conductivity / largest
/// conductivity, the temperature itself where conductivity is constant.
RisingIntegral kirchhoff_potential(const Thermal& material);

}  // namespace lapilli
