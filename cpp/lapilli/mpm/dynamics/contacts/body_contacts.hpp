#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lapilli/mpm/dynamics/contacts/contact_groups.hpp"
#include "lapilli/mpm/dynamics/contacts/shared_nodes.hpp"
#include "lapilli/mpm/dynamics/solve_nodes.hpp"
#include "lapilli/mpm/transfer/body_touch.hpp"

namespace lapilli {

/// Contact between bodies, in the order of a momentum step: at every node that two fields share
/// equal and opposite impulses keep them from closing faster than the gap between their surfaces
/// allows, and from sliding within Coulomb's cone (Bardenhagen et al. 2000, CMAME 187:529; with the
/// surfaces' own gap and normal, see SharedNodes). Bodies part freely.
template <int Dim>
class BodyContacts {
 public:
  BodyContacts(const DynamicsData<Dim>& data, const std::vector<DynamicsBody>& bodies,
               ContactGroups groups);

  /// Impulses on what the forces accelerated; points must be where the nodes act on them. Changes
  /// velocity and increment of the nodes, and the sums.
  void push(DynamicsData<Dim>& data, double step, NodeSums& sums);

  /// What that means for the velocity projected again (MUSL), which only strains: books nothing.
  void push_second(DynamicsData<Dim>& data, double step);

  /// Keep, from here on, where bodies touch; nodal masses must be there.
  void keep_touches(const DynamicsData<Dim>& data);
  /// As found in the last step.
  const std::vector<BodyTouch>& touches() const { return touches_; }

  double friction() const { return friction_; }  // J, lost since the start (negative)
  double impact() const { return impact_; }      // J, the same across the surfaces
  std::vector<std::pair<std::string, double>> diagnostics() const;

  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  struct Impulse {
    double push = 0.0;                 // N s, along the normal
    Vec<Dim> drag = Vec<Dim>::Zero();  // N s, along the surface

    bool acts() const { return push > 0.0 || !drag.isZero(0.0); }
  };

  /// What friction and adhesion bear at a node, N s.
  static double most_drag(const ContactLaw& law, const SharedNode<Dim>& node,
                          const Impulse& impulse, double step) {
    const bool grips = impulse.push > 0.0 || node.touches;
    return law.friction * impulse.push + (grips ? law.adhesion * node.area * step : 0.0);
  }

  void find_touches(const DynamicsData<Dim>& data);
  void improve(const double* mass, const AxisArrays<Dim>& velocity, double step, std::size_t pair,
               std::vector<Impulse>& all);
  std::vector<Impulse> solve(const double* mass, const AxisArrays<Dim>& velocity, double step);
  void book(DynamicsData<Dim>& data, double step, NodeSums& sums);

  ContactGroups groups_;
  SharedNodes<Dim> shared_;
  std::vector<Impulse> impulses_;  // of all shared nodes
  std::vector<Vec<Dim>> before_;   // m/s, velocity of the touched nodes before the impulses
  std::vector<Vec3> force_;        // N, of a pair on its second field in the last step
  double friction_ = 0.0, impact_ = 0.0;
  double touching_ = 0.0;  // nodes that push
  bool keeps_touches_ = false;
  std::vector<BodyTouch> touches_;
};

/// Contact of these groups, or null where all bodies are one. Splits the fields of `data`.
template <int Dim>
std::unique_ptr<BodyContacts<Dim>> make_contacts(DynamicsData<Dim>& data,
                                                 const std::vector<DynamicsBody>& bodies,
                                                 ContactGroups groups);

}  // namespace lapilli
