#include "lapilli/mpm/dynamics/load_shares.hpp"

#include <algorithm>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

/// Call body(k, shares) for every node with room for the shares of its fields.
template <int Dim, class Body>
std::vector<Vec<Dim>> for_each_node(const DynamicsData<Dim>& data, std::size_t count,
                                    const Body& body) {
  const auto fields = static_cast<std::size_t>(data.fields.count());
  std::vector<Vec<Dim>> shares(count * fields, Vec<Dim>::Zero());
  parallel_for(static_cast<Index>(count), [&](Index k) {
    body(static_cast<std::size_t>(k), std::span<Vec<Dim>>(shares.data() + k * fields, fields));
  });
  return shares;
}

/// The free surface of each field at a node: where two of them meet, their faces look at each
/// other, and what they have of opposite sign along an axis cancels.
template <int Dim>
void find_free(const DynamicsData<Dim>& data, const FieldAreas<Dim>& areas, Index node,
               std::span<Vec<Dim>> own) {
  Vec<Dim> outward = Vec<Dim>::Zero(), inward = Vec<Dim>::Zero();
  for (std::size_t field = 0; field < own.size(); ++field) {
    const Index here = data.fields.node_in(static_cast<int>(field), node);
    if (here >= 0 && data.nodes.mass()[here] > data.empty_node) {
      for (int axis = 0; axis < Dim; ++axis) {
        own[field][axis] = areas.along[axis][here];
      }
      outward += own[field].cwiseMax(0.0);
      inward -= own[field].cwiseMin(0.0);
    }
  }
  for (Vec<Dim>& area : own) {
    for (int axis = 0; axis < Dim; ++axis) {
      const double same = area[axis] > 0.0 ? outward[axis] : inward[axis];
      const double other = area[axis] > 0.0 ? inward[axis] : outward[axis];
      area[axis] *= same > other ? (same - other) / same : 0.0;
    }
  }
}

/// Of what has no free surface: by mass.
template <int Dim>
void share_by_mass(const DynamicsData<Dim>& data, Index node, std::span<Vec<Dim>> shares,
                   const auto& is_open) {
  double total = 0.0;
  const auto mass_of = [&](std::size_t field) {
    const Index here = data.fields.node_in(static_cast<int>(field), node);
    const double mass = here < 0 ? 0.0 : data.nodes.mass()[here];
    return mass > data.empty_node ? mass : 0.0;
  };
  for (std::size_t field = 0; field < shares.size(); ++field) {
    total += mass_of(field);
  }
  for (std::size_t field = 0; field < shares.size() && total > 0.0; ++field) {
    for (int axis = 0; axis < Dim; ++axis) {
      if (is_open(axis)) {
        shares[field][axis] = mass_of(field) / total;
      }
    }
  }
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> shares_of_pressure(const DynamicsData<Dim>& data,
                                         const FieldAreas<Dim>& areas,
                                         const std::vector<Index>& nodes) {
  return for_each_node<Dim>(data, nodes.size(), [&](std::size_t k, std::span<Vec<Dim>> shares) {
    find_free(data, areas, nodes[k], shares);
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const Vec<Dim>& area : shares) {
      sum += area;
    }
    for (Vec<Dim>& area : shares) {
      for (int axis = 0; axis < Dim; ++axis) {
        area[axis] = sum[axis] != 0.0 ? area[axis] / sum[axis] : 0.0;
      }
    }
    share_by_mass<Dim>(data, nodes[k], shares, [&](int axis) { return sum[axis] == 0.0; });
  });
}

template <int Dim>
std::vector<Vec<Dim>> shares_of_traction(const DynamicsData<Dim>& data,
                                         const FieldAreas<Dim>& areas,
                                         const std::vector<Index>& nodes,
                                         const std::vector<Vec<Dim>>& normals) {
  return for_each_node<Dim>(data, nodes.size(), [&](std::size_t k, std::span<Vec<Dim>> shares) {
    find_free(data, areas, nodes[k], shares);
    double sum = 0.0;
    for (Vec<Dim>& area : shares) {
      const double along = std::max(0.0, area.dot(normals[k]));
      area.setConstant(along);
      sum += along;
    }
    for (Vec<Dim>& area : shares) {
      area *= sum > 0.0 ? 1.0 / sum : 0.0;
    }
    share_by_mass<Dim>(data, nodes[k], shares, [&](int) { return !(sum > 0.0); });
  });
}

#define LAPILLI_INSTANTIATE(Dim)                                                    \
  template std::vector<Vec<Dim>> shares_of_pressure(                                \
      const DynamicsData<Dim>&, const FieldAreas<Dim>&, const std::vector<Index>&); \
  template std::vector<Vec<Dim>> shares_of_traction(                                \
      const DynamicsData<Dim>&, const FieldAreas<Dim>&, const std::vector<Index>&,  \
      const std::vector<Vec<Dim>>&);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
