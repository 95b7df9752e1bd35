#include "lapilli/peridynamics/conduction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

using lanes::multiply_add;

constexpr Index piece = 256;   // points handed to a thread at once
constexpr Index row_size = 8;  // doubles
constexpr double far = 1e100;  // no adiabatic wall near
constexpr int sweeps_at_rest = 200;
constexpr double sweep_damping = 0.7;

template <class Body>
void over_points(Index rows, const Body& body) {
  parallel_tasks((rows + piece - 1) / piece, [&](Index task) {
    for (Index row = task * piece; row < std::min(rows, (task + 1) * piece); ++row) {
      body(row);
    }
  });
}

std::vector<FamilyRole> roles_of(const WallSurface& walls) {
  std::vector<FamilyRole> roles;
  for (Index body = 0; body < walls.bodies(); ++body) {
    const bool wall = walls.wall_of_body(body) >= 0;
    roles.push_back({wall ? Member::neighbour : Member::owner, wall});
  }
  return roles;
}

}  // namespace

template <int Dim>
Conduction<Dim>::Conduction(Points& points, const WallSurface& walls,
                            const PeridynamicHeatSettings& settings)
    : points_(points),
      walls_(walls),
      settings_(settings),
      weight_{settings.influence, settings.horizon * walls.spacing(), walls.spacing(), true},
      lattice_constant_(2.0 / lattice_moment(Dim, weight_)),
      corrected_(settings.laplacian == Laplacian::corrected),
      families_(points, weight_.horizon, settings.skin * walls.spacing(), roles_of(walls)),
      correction_(points, Dim),
      normaliser_(points, 1, lattice_constant_) {
  const auto rows = static_cast<std::size_t>(points.size());
  rows_.assign(rows * row_size, 0.0);
  insulation_.assign(rows, far);
  insulation_normal_.assign(rows, nullptr);
  bond_area_.assign(walls.walls().size(), 0.0);
  wall_area_.assign(walls.walls().size(), 0.0);
}

template <int Dim>
void Conduction<Dim>::update() {
  if (version_ == points_.version() && ordering_ == points_.ordering()) {
    return;
  }
  weigh_bonds();
  for (int sweep = 0; sweep < sweeps_at_rest && first_ && corrected_; ++sweep) {
    balance(sweep_damping);
  }
  // Points that move keep the correction of the step before and improve it by one sweep.
  balance(corrected_ && !first_ && !keep_correction_ ? sweep_damping : 0.0);
  measure_walls();
  version_ = points_.version();
  ordering_ = points_.ordering();
  first_ = keep_correction_ = false;
}

template <int Dim>
void Conduction<Dim>::refresh() {
  if (first_ || version_ != points_.version() || ordering_ != points_.ordering()) {
    weigh_bonds();
    balance(0.0);
    measure_walls();
  }
}

template <int Dim>
void Conduction<Dim>::weigh_bonds() {
  families_.update();
  gather_rows();
  find_images();
  weigh();
}

template <int Dim>
void Conduction<Dim>::gather_rows() {
  const auto position = points_.position();
  const auto volume = points_.volume();
  over_points(points_.size(), [&](Index i) {
    double* row = rows_.data() + i * row_size;
    for (int d = 0; d < Dim; ++d) {
      row[d] = position[i * Dim + d];
      row[4 + d] = correction_[i * Dim + d];
    }
    const int wall = walls_.wall(i);
    const bool adiabatic = wall >= 0 && walls_.walls()[wall].settings.heat == WallHeat::adiabatic;
    row[3] = adiabatic ? 0.0 : volume[i];
    row[7] = normaliser_[i];
  });
}

template <int Dim>
void Conduction<Dim>::find_images() {
  if (!corrected_) {
    return;
  }
  over_points(points_.size(), [&](Index i) {
    insulation_[i] = far;
    insulation_normal_[i] = nullptr;
    double nearest = far;
    for (Index bond = families_.wall_begin(i); bond < families_.end(i); ++bond) {
      const Index j = families_.neighbour(bond);
      if (rows_[j * row_size + 3] != 0.0) {
        continue;
      }
      double squared = 0.0;
      for (int d = 0; d < Dim; ++d) {
        squared += std::pow(rows_[j * row_size + d] - rows_[i * row_size + d], 2);
      }
      if (squared < nearest) {
        nearest = squared;
        insulation_[i] = std::max(0.0, walls_.template distance<Dim>(&rows_[i * row_size], j));
        insulation_normal_[i] = walls_.normal(j);
      }
    }
  });
}

template <int Dim>
void Conduction<Dim>::weigh() {
  bond_weight_.resize(static_cast<std::size_t>(families_.bonds()));
  image_weight_.resize(corrected_ ? bond_weight_.size() : 0);
  const lanes::BondWeightLanes weight(weight_);
  const std::int32_t* neighbours = families_.neighbours();
  over_points(points_.size(), [&](Index i) {
    const double* own = rows_.data() + i * row_size;
    const Quad x = all(own[0]), y = all(own[1]), z = all(own[2]);
    Quad moment = all(0.0);
    for (Index k = families_.begin(i); k < families_.padded_end(i); k += lanes::width) {
      Quad a = load_quad(rows_.data() + neighbours[k] * row_size);
      Quad b = load_quad(rows_.data() + neighbours[k + 1] * row_size);
      Quad c = load_quad(rows_.data() + neighbours[k + 2] * row_size);
      Quad v = load_quad(rows_.data() + neighbours[k + 3] * row_size);
      lanes::transpose(a, b, c, v);
      a -= x;
      b -= y;
      c -= z;
      const Quad squared = a * a + b * b + c * c;
      const Quad w = weight(squared, square_root(squared)) * v;
      store_quad(bond_weight_.data() + k, w);
      moment = multiply_add(w, squared, moment);
    }
    if (!corrected_) {
      return;
    }
    double total = lanes::sum(moment);
    if (insulation_[i] < far) {
      const double own_image = 2.0 * insulation_[i];
      total += weight_(own_image) * own_image * own_image * own[3];
      for (Index k = families_.begin(i); k < families_.wall_begin(i); ++k) {
        const double* other = rows_.data() + neighbours[k] * row_size;
        double squared = 4.0 * insulation_[i] * insulation_[neighbours[k]];
        for (int d = 0; d < Dim; ++d) {
          squared += (other[d] - own[d]) * (other[d] - own[d]);
        }
        const double w =
            squared < weight_.horizon * weight_.horizon ? weight_(std::sqrt(squared)) : 0.0;
        image_weight_[k] = w * other[3];
        total += image_weight_[k] * squared;
      }
    }
    if (first_ && total > 0.0) {
      normaliser_[i] = 2.0 * Dim / total;
    }
  });
  if (first_) {
    over_points(points_.size(), [&](Index i) { rows_[i * row_size + 7] = normaliser_[i]; });
  }
}

template <int Dim>
void Conduction<Dim>::balance(double damping) {
  conductance_.resize(bond_weight_.size());
  const std::int32_t* neighbours = families_.neighbours();
  const double half_conductivity = 0.5 * settings_.conductivity;
  over_points(points_.size(), [&](Index i) {
    if (!families_.owns(i)) {
      return;
    }
    const double* own = rows_.data() + i * row_size;
    const Quad x = all(own[0]), y = all(own[1]), z = all(own[2]);
    const Quad lx = all(own[4]), ly = all(own[5]), lz = all(own[6]);
    const Quad c_own = all(own[7]);
    const Quad scale = all(half_conductivity * own[3]);
    const Quad bound = all(0.8);
    Quad out_x = all(0.0), out_y = out_x, out_z = out_x, moment = out_x;
    for (Index k = families_.begin(i); k < families_.padded_end(i); k += lanes::width) {
      const std::int32_t* j = neighbours + k;
      Quad a = load_quad(rows_.data() + j[0] * row_size),
           al = load_quad(rows_.data() + j[0] * row_size + 4);
      Quad b = load_quad(rows_.data() + j[1] * row_size),
           bl = load_quad(rows_.data() + j[1] * row_size + 4);
      Quad c = load_quad(rows_.data() + j[2] * row_size),
           cl = load_quad(rows_.data() + j[2] * row_size + 4);
      Quad v = load_quad(rows_.data() + j[3] * row_size),
           vl = load_quad(rows_.data() + j[3] * row_size + 4);
      lanes::transpose(a, b, c, v);
      lanes::transpose(al, bl, cl, vl);
      a -= x;
      b -= y;
      c -= z;
      Quad tilt = (lx - al) * a + (ly - bl) * b + (lz - cl) * c;
      tilt = lanes::choose(tilt > bound, bound, lanes::choose(tilt < -bound, -bound, tilt));
      const Quad w = load_quad(bond_weight_.data() + k) * (all(1.0) + tilt);
      moment = multiply_add(w, a * a + b * b + c * c, moment);
      const Quad s = w * (c_own + vl);
      store_quad(conductance_.data() + k, s * scale);
      out_x = multiply_add(s, a, out_x);
      out_y = multiply_add(s, b, out_y);
      out_z = multiply_add(s, c, out_z);
    }
    double out[3] = {lanes::sum(out_x), lanes::sum(out_y), lanes::sum(out_z)};
    double total = lanes::sum(moment);
    if (corrected_ && insulation_[i] < far) {
      total += add_images(i, out);
    }
    // The sweep divides by the diagonal block, sum of s Y Y = 4 on a full lattice.
    for (int d = 0; d < Dim; ++d) {
      correction_[i * Dim + d] = own[4 + d] - damping * 0.25 * out[d];
    }
    if (damping > 0.0 && total > 0.0) {
      normaliser_[i] = 2.0 * Dim / total;
    }
  });
  if (damping > 0.0) {
    over_points(points_.size(), [&](Index i) {
      for (int d = 0; d < Dim; ++d) {
        rows_[i * row_size + 4 + d] = correction_[i * Dim + d];
      }
      rows_[i * row_size + 7] = normaliser_[i];
    });
  }
}

template <int Dim>
double Conduction<Dim>::add_images(Index i, double* out) {
  const double* own = rows_.data() + i * row_size;
  const double* n = insulation_normal_[i];
  const double own_image = 2.0 * insulation_[i];
  const double w_own = own[3] * weight_(own_image);
  double moment = w_own * own_image * own_image;
  for (int d = 0; d < Dim; ++d) {
    out[d] -= 2.0 * own[7] * w_own * own_image * n[d];
  }
  for (Index k = families_.begin(i); k < families_.wall_begin(i); ++k) {
    const Index j = families_.neighbour(k);
    const double* other = rows_.data() + j * row_size;
    const double s = image_weight_[k] * (own[7] + other[7]);
    if (s == 0.0) {
      continue;
    }
    conductance_[k] += 0.5 * settings_.conductivity * s * own[3];
    double squared = 4.0 * insulation_[i] * insulation_[j];
    for (int d = 0; d < Dim; ++d) {
      squared += (other[d] - own[d]) * (other[d] - own[d]);
      out[d] += s * (other[d] - own[d] - 2.0 * insulation_[j] * n[d]);
    }
    moment += image_weight_[k] * squared;
  }
  return moment;
}

template <int Dim>
template <class Body>
void Conduction<Dim>::for_wall_bonds(Index point, const Body& body) const {
  const double least = 0.1 * walls_.spacing();
  for (Index bond = families_.wall_begin(point); bond < families_.end(point); ++bond) {
    if (conductance_[bond] == 0.0) {
      continue;
    }
    const Index j = families_.neighbour(bond);
    const double ahead =
        std::max(least, walls_.template distance<Dim>(&rows_[point * row_size], j));
    const double area = conductance_[bond] * (ahead + walls_.depth(j)) / settings_.conductivity;
    body(WallBond{j, walls_.wall(j), area, ahead});
  }
}

template <int Dim>
void Conduction<Dim>::measure_walls() {
  std::fill(bond_area_.begin(), bond_area_.end(), 0.0);
  for (Index i = 0; i < points_.size(); ++i) {
    if (families_.owns(i) && families_.wall_begin(i) < families_.end(i)) {
      for_wall_bonds(i, [&](const WallBond& bond) { bond_area_[bond.wall] += bond.area; });
    }
  }
  if (first_) {
    wall_area_ = bond_area_;
  }
}

template <int Dim>
double Conduction<Dim>::flux_through(const WallBond& bond, const WallState& state,
                                     double temperature) const {
  const WallSettings& wall = walls_.walls()[bond.wall].settings;
  switch (wall.heat) {
    case WallHeat::temperature:
      return settings_.conductivity * (state.temperature - temperature) / bond.distance;
    case WallHeat::flux:
      return state.flux;
    case WallHeat::convection:
      return wall.coefficient > 0.0
                 ? (state.temperature - temperature) /
                       (bond.distance / settings_.conductivity + 1.0 / wall.coefficient)
                 : 0.0;
    case WallHeat::adiabatic:
      break;
  }
  return 0.0;
}

template <int Dim>
void Conduction<Dim>::rates(const double* temperature, const std::vector<WallState>& surface,
                            double* rate, std::vector<double>& from_walls) const {
  const std::int32_t* neighbours = families_.neighbours();
  const auto walls = static_cast<Index>(surface.size());
  const Index tasks = (points_.size() + piece - 1) / piece;
  std::vector<double> partial(static_cast<std::size_t>(tasks * walls), 0.0);
  // Prescribed fluxes bring in flux times the area of the wall, however the bonds lie.
  std::vector<double> share(surface.size(), 1.0);
  for (Index k = 0; k < walls; ++k) {
    const WallHeat kind = walls_.walls()[k].settings.heat;
    if ((kind == WallHeat::flux || kind == WallHeat::convection) && bond_area_[k] > 0.0) {
      share[k] = wall_area_[k] / bond_area_[k];
    }
  }
  parallel_tasks(tasks, [&](Index task) {
    for (Index i = task * piece; i < std::min(points_.size(), (task + 1) * piece); ++i) {
      rate[i] = 0.0;
      if (!families_.owns(i)) {
        continue;
      }
      const double own = temperature[i];
      double sum = 0.0;
      for (Index k = families_.begin(i); k < families_.wall_begin(i); ++k) {
        sum += conductance_[k] * (temperature[neighbours[k]] - own);
      }
      if (families_.wall_begin(i) < families_.end(i)) {
        for_wall_bonds(i, [&](const WallBond& bond) {
          const double heat =
              share[bond.wall] * bond.area * flux_through(bond, surface[bond.wall], own);
          partial[task * walls + bond.wall] += heat;
          sum += heat;
        });
      }
      rate[i] = sum;
    }
  });
  from_walls.assign(surface.size(), 0.0);
  for (Index task = 0; task < tasks; ++task) {
    for (Index k = 0; k < walls; ++k) {
      from_walls[k] += partial[task * walls + k];
    }
  }
}

template <int Dim>
double Conduction<Dim>::imbalance() const {
  double largest = 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (!families_.owns(i) || families_.wall_begin(i) < families_.end(i)) {
      continue;
    }
    Vec<Dim> out = Vec<Dim>::Zero();
    double scale = 0.0;
    for (Index k = families_.begin(i); k < families_.end(i); ++k) {
      const Vec<Dim> bond =
          points_.position<Dim>(families_.neighbour(k)) - points_.position<Dim>(i);
      out += conductance_[k] * bond;
      scale += conductance_[k] * bond.norm();
    }
    if (scale > 0.0) {
      largest = std::max(largest, out.norm() / scale);
    }
  }
  return largest;
}

template <int Dim>
double Conduction<Dim>::wall_flux(int wall, const Vec3& place, double reach,
                                  const double* temperature,
                                  const std::vector<WallState>& surface) const {
  double flux = 0.0, total = 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (!families_.owns(i) || families_.wall_begin(i) == families_.end(i)) {
      continue;
    }
    double squared = 0.0;
    for (int d = 0; d < Dim; ++d) {
      squared += std::pow(rows_[i * row_size + d] - place[d], 2);
    }
    if (squared > 16.0 * reach * reach) {
      continue;
    }
    for_wall_bonds(i, [&](const WallBond& bond) {
      if (bond.wall == wall) {
        const double across = squared - bond.distance * bond.distance;
        const double w = bond.area * std::exp(-across / (reach * reach));
        flux += w * flux_through(bond, surface[wall], temperature[i]);
        total += w;
      }
    });
  }
  return total > 0.0 ? flux / total : 0.0;
}

template <int Dim>
void Conduction<Dim>::save(Archive& archive) const {
  families_.save(archive, "heat/families");
  archive.write("heat/correction", correction_.values());
  archive.write("heat/wall_area", wall_area_);
  archive.write("heat/normaliser", normaliser_.values());
  archive.write("heat/weighed", static_cast<Index>(first_ ? 0 : 1));
  archive.write("heat/at_rest", static_cast<Index>(version_ == points_.version() ? 1 : 0));
}

template <int Dim>
void Conduction<Dim>::load(const Archive& archive) {
  families_.load(archive, "heat/families");
  archive.read("heat/correction", correction_.values());
  archive.read("heat/wall_area", wall_area_);
  archive.read("heat/normaliser", normaliser_.values());
  first_ = archive.read_index("heat/weighed") == 0;
  // Points at rest keep the conductances of their one search.
  keep_correction_ = archive.read_index("heat/at_rest") == 1;
  version_ = -1;
}

template class Conduction<1>;
template class Conduction<2>;
template class Conduction<3>;

}  // namespace lapilli
