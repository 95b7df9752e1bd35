#include "lapilli/mpm/quasi_static/quasi_static.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/quasi_static/blurred_faces.hpp"
#include "lapilli/mpm/quasi_static/support_terms.hpp"

namespace lapilli {

template <int Dim>
std::vector<Field> QuasiStatic<Dim>::fields() {
  std::vector<Field> all{{"displacement", "m", Dim, displacement_.values()}};
  std::ranges::copy(solids_.fields(), std::back_inserter(all));
  return all;
}

template <int Dim>
void QuasiStatic<Dim>::save(Archive& archive) const {
  archive.write("quasi_static/moved_far", Index{moved_far_});
  solids_.save(archive);
  archive.write("quasi_static/displacement", displacement_.values());
  archive.write("quasi_static/start_volume", start_volume_.values());
  archive.write("quasi_static/guarded", guarded_.values());
  std::vector<double> forces;
  for (const Vec<Dim>& force : support_forces_) {
    forces.insert(forces.end(), force.data(), force.data() + Dim);
  }
  archive.write("quasi_static/support_forces", std::span<const double>(forces));
  if (half_width_) {
    archive.write("quasi_static/half_width", std::as_const(*half_width_).values());
  }
  archive.write("quasi_static/largest_force", largest_force_);
  archive.write("quasi_static/largest_left", largest_left_);
  steps_.save(archive);
  reference_.save(archive);
}

template <int Dim>
void QuasiStatic<Dim>::load(const Archive& archive) {
  solids_.load(archive);
  archive.read("quasi_static/displacement", displacement_.values());
  archive.read("quasi_static/start_volume", start_volume_.values());
  archive.read("quasi_static/guarded", guarded_.values());
  const std::vector<double> forces = archive.read_numbers("quasi_static/support_forces");
  for (std::size_t w = 0; w < support_forces_.size(); ++w) {
    support_forces_[w] = Eigen::Map<const Vec<Dim>>(forces.data() + Dim * w);
  }
  if (half_width_) {
    archive.read("quasi_static/half_width", half_width_->values());
  }
  largest_force_ = archive.read_number("quasi_static/largest_force");
  largest_left_ = archive.read_number("quasi_static/largest_left");
  steps_.load(archive);
  choose_stiffness(archive.read_index("quasi_static/moved_far") != 0);
  reference_.scheme = scheme_;
  reference_.load(archive);
  reference_.locate(grid_, points_, solids_.elastic(), averaged_, boundary_);
}

/// Zienkiewicz & Zhu 1987: stresses averaged to the nodes and read again at the points, body by
/// body, are nearer to the truth; the energy of the difference measures the error of theirs.
template <int Dim>
double QuasiStatic<Dim>::roughness() const {
  constexpr int nodes = 1 << Dim;
  using Six = Eigen::Matrix<double, 6, 1>;
  struct Averaged {
    Six stress = Six::Zero();
    double volume = 0.0;
  };
  std::map<std::pair<Index, Index>, Averaged> node_of;  // by body and node
  const auto visit = [&](Index p, const auto& body) {
    const auto cell = grid_.cell_containing(points_.position<Dim>(p));
    CellBox<Dim> box{cell, {}};
    box.cells.fill(1);
    double value[nodes];
    Vec<Dim> gradient[nodes];
    cell_shape<Dim>(grid_, cell, points_.position<Dim>(p), value, gradient);
    for_each_node(grid_, box, [&](int a, Index node) {
      body(value[a], node_of[{points_.body()[p], node}]);
    });
  };
  const auto stress_at = [&](Index p) {
    return Eigen::Map<const Six>(solids_.stress().data() + 6 * p);
  };
  for (Index p = 0; p < points_.size(); ++p) {
    visit(p, [&](double share, Averaged& node) {
      node.stress += share * points_.volume()[p] * stress_at(p);
      node.volume += share * points_.volume()[p];
    });
  }
  double whole = 0.0, changed = 0.0;
  for (Index p = 0; p < points_.size(); ++p) {
    const LinearElastic& material = solids_.elastic(points_.body()[p]);
    const auto energy = [&](const Six& s) {
      const double nu = material.poissons_ratio, trace = s.head<3>().sum();
      return points_.volume()[p] / material.youngs_modulus *
             ((1.0 + nu) * (s.head<3>().squaredNorm() + 2.0 * s.tail<3>().squaredNorm()) -
              nu * trace * trace);
    };
    Six smooth = Six::Zero();
    visit(p, [&](double share, Averaged& node) {
      smooth += share / std::max(node.volume, 1e-300) * node.stress;
    });
    whole += energy(stress_at(p));
    changed += energy(stress_at(p) - smooth);
  }
  // What is left once loads are taken off says nothing.
  constexpr double nothing = 1e-6;
  const double h = grid_.cell_size(), stress = nothing * largest_force_ / std::pow(h, Dim - 1);
  const double least = stress * stress * std::pow(h, Dim) / solids_.elastic()[0].youngs_modulus;
  return whole > least ? changed / whole : 0.0;
}

template <int Dim>
double QuasiStatic<Dim>::farthest_moved() const {
  double most = 0.0;
  for (const double moved : displacement_.values()) {
    most = std::max(most, std::abs(moved));
  }
  return most;
}

template <int Dim>
double QuasiStatic<Dim>::size_of_moves() const {
  double squared = 0.0;
  for (const double moved : displacement_.values()) {
    squared += moved * moved;
  }
  return std::sqrt(squared / static_cast<double>(points_.size()));
}

template <int Dim>
std::vector<Note> QuasiStatic<Dim>::warnings() const {
  // Of 126 drawn scenes those whose displacements are off by more than 3 % have a roughness above
  // 0.006, and most above it are off by more than 1 %.
  constexpr double small = 0.02, smooth = 0.006, crossing = 0.5, noticed = 0.03;
  std::vector<Note> all(notes_);
  if (largest_left_ > 0.0) {
    all.push_back(note("quasi_static.stalled",
                       "quasi_static: Newton's method stalled in a load step with a share of ",
                       largest_left_, " of the forces out of balance, tolerance ",
                       settings_.tolerance, ": more load steps or max_iterations bring less"));
  }
  if (const double strain = solids_.largest_strain(points_); strain > small) {
    all.push_back(note("quasi_static.large-strain", "quasi_static: the largest strain is ", strain,
                       "; the law is one of small strains, good to about ", small));
  }
  if (const double share = roughness(); share > smooth) {
    all.push_back(note("quasi_static.coarse",
                       "quasi_static: the cells are coarse for the stresses, whose energy is off "
                       "by about ",
                       100.0 * share,
                       " %: displacements may be off by several percent; halve grid.cell to see"));
  }
  const BlurredFace face = worst_blurred_face<Dim>(grid_, points_, solids_);
  if (const double size = size_of_moves(); face.missing > noticed * size) {
    all.push_back(note(
        "quasi_static.blurred-face", "quasi_static: body ", face.body,
        " strains like a stiffer one in the cells that they share, ", "which takes about ",
        face.missing, " m off its displacement across their face, ",
        std::round(100.0 * face.missing / size), " % of what the points have moved: put the face ",
        "on a line of the grid, or take smaller cells"));
  }
  if (const double moved = farthest_moved() / grid_.cell_size(); !half_width_ && moved > crossing) {
    all.push_back(note("quasi_static.crossed-cells", "quasi_static: points have moved by up to ",
                       moved,
                       " cells, and linear shape functions leave errors of several percent where "
                       "points cross cells: take grid.shape_function = \"gimp\""));
  }
  return all;
}

template <int Dim>
std::vector<std::pair<std::string, double>> QuasiStatic<Dim>::diagnostics() const {
  std::vector<std::pair<std::string, double>> numbers{
      {"iterations", report_.newton.iterations},
      {"residual", report_.newton.residual},
      {"smallest pivot", report_.pivots.smallest},
      {"largest pivot", report_.pivots.largest},
      {"condition estimate", report_.condition},
      {"halvings", report_.halvings},
      {"deepest penetration", report_.penetration},
      {"largest strain", solids_.largest_strain(points_)},
  };
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t w = 0; w < boundary_.walls(); ++w) {
    for (int axis = 0; axis < Dim; ++axis) {
      numbers.emplace_back("force of wall '" + boundary_.names()[w] + "' along " + axes[axis],
                           support_forces_[w][axis]);
    }
  }
  return numbers;
}

#define LAPILLI_INSTANTIATE(Dim)                                 \
  template std::vector<Field> QuasiStatic<Dim>::fields();        \
  template void QuasiStatic<Dim>::save(Archive& archive) const;  \
  template void QuasiStatic<Dim>::load(const Archive& archive);  \
  template std::vector<Note> QuasiStatic<Dim>::warnings() const; \
  template double QuasiStatic<Dim>::roughness() const;           \
  template double QuasiStatic<Dim>::farthest_moved() const;      \
  template double QuasiStatic<Dim>::size_of_moves() const;       \
  template std::vector<std::pair<std::string, double>> QuasiStatic<Dim>::diagnostics() const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
