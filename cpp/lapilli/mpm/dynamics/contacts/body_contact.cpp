#include "lapilli/mpm/dynamics/contacts/body_contact.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

void check(const BodyContact& contact, int index) {
  const std::string where = message("dynamics.contacts.", index);
  require(contact.bodies.empty() || contact.bodies.size() == 2, where,
          ".bodies needs the names of two bodies, or none, got ", contact.bodies.size());
  require(contact.bodies.empty() || contact.bodies[0] != contact.bodies[1], where, ".bodies names ",
          contact.bodies.empty() ? "" : contact.bodies[0],
          " twice: a body has no contact with itself");
  require(std::isfinite(contact.friction) && contact.friction >= 0.0, where,
          ".friction must not be negative, got ", contact.friction);
  require(std::isfinite(contact.adhesion) && contact.adhesion >= 0.0, where,
          ".adhesion must not be negative, got ", contact.adhesion);
  require(contact.contact == ContactKind::frictional ||
              (contact.friction == 0.0 && contact.adhesion == 0.0),
          where, ".friction and .adhesion belong to contact = \"frictional\", this is ",
          name_of(contact.contact));
}

}  // namespace lapilli
