#include "lapilli/mpm/dynamics/contacts/contact_groups.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "lapilli/core/pair_entries.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/project_to_grid.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {
namespace {

/// A common face: more than this share of the nodes around both, by volume, has surfaces nearer
/// than this, in cells. Of two disks that touch in a point it is .2, whatever their size.
constexpr double common_share = 0.5, together = 0.1;
/// Velocities are the same up to this share of the wave speed.
constexpr double same_velocity = 1e-6;

std::vector<std::string> names_of(const std::vector<DynamicsBody>& bodies) {
  std::vector<std::string> names;
  for (const DynamicsBody& body : bodies) {
    names.push_back(body.name);
  }
  return names_or_numbers(std::move(names));
}

int root_of(std::vector<int>& group, int body) {
  while (group[body] != body) {
    body = group[body] = group[group[body]];
  }
  return body;
}

void join(std::vector<int>& group, int a, int b) {
  const int one = root_of(group, a), two = root_of(group, b);
  group[std::max(one, two)] = std::min(one, two);
}

/// Whether two bodies start as one: the shared nodes of their fields.
template <int Dim>
bool lie_together(const DynamicsData<Dim>& data, std::span<const SharedNode<Dim>> nodes,
                  double wave_speed) {
  const double near = together * data.grid.cell_size();
  double all = 0.0, close = 0.0;
  for (const SharedNode<Dim>& node : nodes) {
    all += node.weight;
    if (node.gap > near) {
      continue;
    }
    close += node.weight;
    double square = 0.0;
    for (int axis = 0; axis < Dim; ++axis) {
      // Momentum: the nodes are not solved.
      const double* momentum = data.nodes.velocity(axis);
      const double apart = momentum[node.second] / data.nodes.mass()[node.second] -
                           momentum[node.first] / data.nodes.mass()[node.first];
      square += apart * apart;
    }
    if (std::sqrt(square) > same_velocity * wave_speed) {
      return false;
    }
  }
  return close > common_share * all;
}

template <int Dim>
double slowest_wave(const DynamicsData<Dim>& data) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const StressMaterial& material : data.materials) {
    slowest = std::min(slowest, std::sqrt(material.wave_modulus / material.density));
  }
  return slowest;
}

/// What the state before says of two bodies: whether they were one; nothing where one is new.
std::optional<bool> were_one(const PointStart* before, int a, int b) {
  if (before == nullptr || before->body[a] < 0 || before->body[b] < 0) {
    return {};
  }
  if (!before->state->contains("dynamics/fields/of_body")) {
    return true;
  }
  const std::vector<Index> fields = before->state->read_indices("dynamics/fields/of_body");
  return fields.at(before->body[a]) == fields.at(before->body[b]);
}

/// Join the bodies that start as one, of those pairs that no entry is about.
template <int Dim>
void join_by_start(DynamicsData<Dim>& data, const std::vector<DynamicsBody>& bodies,
                   const PairEntries& entries, const PointStart* before, std::vector<int>& group) {
  std::vector<std::pair<int, int>> open;
  const int count = static_cast<int>(bodies.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (entries.of(a, b) >= 0) {
        continue;
      }
      const std::optional<bool> known = were_one(before, a, b);
      if (!known) {
        open.emplace_back(a, b);
      } else if (*known) {
        join(group, a, b);
      }
    }
  }
  if (open.empty()) {
    return;
  }
  std::vector<int> each(bodies.size());
  std::iota(each.begin(), each.end(), 0);
  data.fields.split(each);
  data.fields.place(data.points);
  project_to_grid(data, 0.0);
  SharedNodes<Dim> shared(data, bodies);
  shared.find(data, open);
  const double wave_speed = slowest_wave(data);
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (lie_together<Dim>(data, shared.of(k), wave_speed)) {
      join(group, open[k].first, open[k].second);
    }
  }
}

/// The law between two groups of bodies: an entry about two of them, or the one for all others.
ContactLaw law_between(const std::vector<BodyContact>& contacts, const PairEntries& entries,
                       const std::vector<int>& field_of_body, std::pair<int, int> fields) {
  int found = -1, own = -1;
  const std::size_t count = field_of_body.size();
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      const std::pair<int, int> here = std::minmax(field_of_body[a], field_of_body[b]);
      if (here != fields) {
        continue;
      }
      found = std::max(found, entries.of(a, b));
      const int entry = entries.own(a, b);
      if (entry >= 0) {
        require(own < 0 || (contacts[own].friction == contacts[entry].friction &&
                            contacts[own].adhesion == contacts[entry].adhesion),
                "dynamics.contacts.", own, " and .", entry,
                " name bodies that are bonded to each other: give both the same friction and "
                "adhesion");
        own = entry;
      }
    }
  }
  const int entry = own >= 0 ? own : found;
  return entry < 0 ? ContactLaw{}
                   : ContactLaw{contacts[entry].friction, contacts[entry].adhesion, {}};
}

}  // namespace

template <int Dim>
ContactGroups contact_groups(DynamicsData<Dim>& data, const std::vector<DynamicsBody>& bodies,
                             const PointStart* before) {
  const std::vector<BodyContact>& contacts = data.settings.contacts;
  const std::vector<std::string> names = names_of(bodies);
  std::vector<std::vector<std::string>> named;
  for (const BodyContact& contact : contacts) {
    named.push_back(contact.bodies);
  }
  const PairEntries entries("dynamics.contacts", named, names);
  const int count = static_cast<int>(bodies.size());
  std::vector<int> group(bodies.size());
  std::iota(group.begin(), group.end(), 0);
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      const int entry = entries.of(a, b);
      if (entry >= 0 && contacts[entry].contact == ContactKind::bonded) {
        join(group, a, b);
      }
    }
  }
  join_by_start(data, bodies, entries, before, group);

  ContactGroups result;
  std::vector<std::string> title;
  for (int body = 0; body < count; ++body) {
    const int root = root_of(group, body);
    if (root == body) {
      result.field_of_body.push_back(static_cast<int>(title.size()));
      title.push_back(names[body]);
      result.members.push_back(names[body]);
    } else {
      result.field_of_body.push_back(result.field_of_body[root]);
      result.members[result.field_of_body[root]] += ", " + names[body];
    }
  }
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      const int entry = entries.own(a, b);
      const bool bonded = result.field_of_body[a] == result.field_of_body[b];
      require(entry < 0 || contacts[entry].contact == ContactKind::bonded || !bonded,
              "dynamics.contacts.", entry, ": ", names[a], " and ", names[b],
              " are bonded through other bodies; say contact = \"frictional\" for those too");
    }
  }
  for (int a = 0; a < static_cast<int>(title.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(title.size()); ++b) {
      result.pairs.emplace_back(a, b);
      result.laws.push_back(law_between(contacts, entries, result.field_of_body, {a, b}));
      result.laws.back().name = message(title[a], " on ", title[b]);
    }
  }
  return result;
}

std::vector<std::string> described(const ContactGroups& groups) {
  std::vector<std::string> words;
  for (const std::string& members : groups.members) {
    if (members.find(", ") != std::string::npos) {
      words.push_back(message("bonded bodies: ", members));
    }
  }
  constexpr std::size_t most = 8;
  for (std::size_t k = 0; k < std::min(most, groups.laws.size()); ++k) {
    const ContactLaw& law = groups.laws[k];
    words.push_back(message("contact of ", law.name, ", friction ", law.friction,
                            law.adhesion > 0.0 ? message(", adhesion ", law.adhesion, " Pa") : ""));
  }
  if (groups.laws.size() > most) {
    words.push_back(message("contact of ", groups.laws.size() - most, " more pairs of bodies"));
  }
  return words;
}

template ContactGroups contact_groups(DynamicsData<2>&, const std::vector<DynamicsBody>&,
                                      const PointStart*);
template ContactGroups contact_groups(DynamicsData<3>&, const std::vector<DynamicsBody>&,
                                      const PointStart*);

}  // namespace lapilli
