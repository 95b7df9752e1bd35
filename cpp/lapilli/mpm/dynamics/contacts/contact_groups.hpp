#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lapilli/mpm/dynamics/contacts/shared_nodes.hpp"
#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// Friction of two velocity fields.
struct ContactLaw {
  double friction = 0.0;  // coefficient
  double adhesion = 0.0;  // Pa
  std::string name;       // of the two
};

/// Which bodies move as one, and what those that do not do where they meet.
struct ContactGroups {
  std::vector<int> field_of_body;
  std::vector<std::pair<int, int>> pairs;  // of fields
  std::vector<ContactLaw> laws;            // of the pairs
  std::vector<std::string> members;        // names of the bodies of each field
};

/// What meets and what is one, a few words each.
std::vector<std::string> described(const ContactGroups& groups);

/// Decide by the settings, and where these say nothing by the start: bodies that lie together along
/// a common face, at the same velocity, are one; others are in contact. Two bodies that both go on
/// from `before` (null: none does) are one if they were. Uses nodes and fields of `data`. Throws
/// std::invalid_argument for entries that name unknown bodies or contradict.
template <int Dim>
ContactGroups contact_groups(DynamicsData<Dim>& data, const std::vector<DynamicsBody>& bodies,
                             const PointStart* before = nullptr);

}  // namespace lapilli
