#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/describe.hpp"

namespace lapilli {

/// What two bodies that touch do to each other.
enum class ContactKind { frictional, bonded };

template <>
struct Names<ContactKind> {
  static constexpr std::pair<ContactKind, const char*> values[] = {
      {ContactKind::frictional, "frictional"}, {ContactKind::bonded, "bonded"}};
};

/// What one pair of bodies, or every pair without an entry of its own, does where it meets. Without
/// any entry, bodies that start together along a common face are bonded, all others are in contact
/// without friction.
struct BodyContact {
  std::vector<std::string> bodies;  // two names; empty: every pair that no other entry names
  ContactKind contact = ContactKind::frictional;
  double friction = 0.0;  // coefficient of Coulomb friction
  double adhesion = 0.0;  // Pa of shear on top of it, while in contact

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("bodies").length(0, 2).text(
              "names of the two bodies; empty: every pair that no other entry names"),
          self.bodies);
    visit(Key("contact").text("frictional: parts and slides; bonded: one body, tension included"),
          self.contact);
    visit(Key("friction").non_negative().text("coefficient of Coulomb friction, of frictional"),
          self.friction);
    visit(Key("adhesion").unit("Pa").non_negative().text("shear it bears beyond friction"),
          self.adhesion);
  }
};

/// Throws std::invalid_argument naming the first setting of entry `index` out of range.
void check(const BodyContact& contact, int index);

}  // namespace lapilli
