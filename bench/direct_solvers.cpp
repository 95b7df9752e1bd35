// Processor seconds (of all threads) of the direct solver of load steps beside others, on the
// stiffness of a block of N x N or N x N x N trilinear cells held at its base: analysis,
// factorisation, one solve, relative error of the solution, and whether one and two threads give
// the same bytes. Usage: direct_solvers 2|3 cells-a-side ...
//
// Built with BENCH_SUITESPARSE (and its headers and libraries) also CHOLMOD and UMFPACK.
#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <memory>
#ifdef BENCH_SUITESPARSE
#include <Eigen/CholmodSupport>
#include <Eigen/UmfPackSupport>
#endif

#include "lapilli/algebra/multifrontal.hpp"
#include "lapilli/core/parallel.hpp"

using namespace lapilli;

namespace {

struct System {
  SparseMatrix whole, lower;  // in elimination order
  std::vector<int> part_start;
  Eigen::VectorXd solution, right_side;
};

/// Stiffness of one cell, Lame constants 1 and 1, unit size: two Gauss points an axis.
template <int Dim>
Eigen::MatrixXd cell_stiffness() {
  constexpr int nodes = 1 << Dim;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(Dim * nodes, Dim * nodes);
  for (int q = 0; q < nodes; ++q) {
    Eigen::Matrix<double, Dim, nodes> gradient;
    for (int a = 0; a < nodes; ++a) {
      for (int axis = 0; axis < Dim; ++axis) {
        double product = (a >> axis) & 1 ? 1.0 : -1.0;
        for (int other = 0; other < Dim; ++other) {
          const double x = 0.5 + ((q >> other) & 1 ? 1.0 : -1.0) / std::sqrt(12.0);
          product *= other == axis ? 1.0 : ((a >> other) & 1 ? x : 1.0 - x);
        }
        gradient(axis, a) = product;
      }
    }
    for (int a = 0; a < nodes; ++a) {
      for (int b = 0; b < nodes; ++b) {
        const Vec<Dim> g = gradient.col(a), f = gradient.col(b);
        matrix.block<Dim, Dim>(Dim * a, Dim * b) +=
            (g * f.transpose() + f * g.transpose() + g.dot(f) * Mat<Dim>::Identity()) / nodes;
      }
    }
  }
  return matrix;
}

template <int Dim>
System block(int cells) {
  const int side = cells + 1;
  int count = 1, cell_count = 1;
  for (int axis = 0; axis < Dim; ++axis) {
    count *= side;
    cell_count *= cells;
  }
  const Eigen::MatrixXd local = cell_stiffness<Dim>();
  std::vector<std::array<int, 3>> place(count);
  for (int node = 0; node < count; ++node) {
    int rest = node;
    for (int axis = 0; axis < 3; ++axis, rest /= side) {
      place[node][axis] = axis < Dim ? rest % side : 0;
    }
  }
  std::vector<std::vector<int>> near(count);
  std::vector<std::vector<int>> boxes;
  for (int cell = 0; cell < cell_count; ++cell) {
    std::vector<int> nodes;
    for (int a = 0; a < (1 << Dim); ++a) {
      int rest = cell, node = 0, stride = 1;
      for (int axis = 0; axis < Dim; ++axis, rest /= cells, stride *= side) {
        node += stride * (rest % cells + ((a >> axis) & 1));
      }
      nodes.push_back(node);
    }
    for (int a : nodes) {
      near[a].insert(near[a].end(), nodes.begin(), nodes.end());
    }
    boxes.push_back(std::move(nodes));
  }
  NodeGraph graph;
  graph.start.push_back(0);
  for (std::vector<int>& some : near) {
    std::sort(some.begin(), some.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
    graph.neighbour.insert(graph.neighbour.end(), some.begin(), some.end());
    graph.start.push_back(static_cast<Index>(graph.neighbour.size()));
  }
  const Elimination elimination = nested_dissection(graph, place);
  std::vector<int> row(count);
  for (int k = 0; k < count; ++k) {
    row[elimination.order[k]] = k;
  }
  System system;
  for (int start : elimination.part_start) {
    system.part_start.push_back(Dim * start);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const std::vector<int>& nodes : boxes) {
    for (std::size_t i = 0; i < nodes.size() * Dim; ++i) {
      for (std::size_t j = 0; j < nodes.size() * Dim; ++j) {
        entries.emplace_back(Dim * row[nodes[i / Dim]] + static_cast<int>(i % Dim),
                             Dim * row[nodes[j / Dim]] + static_cast<int>(j % Dim),
                             local(static_cast<int>(i), static_cast<int>(j)));
      }
    }
  }
  for (int node = 0; node < count; ++node) {
    if (place[node][Dim - 1] == 0) {
      for (int axis = 0; axis < Dim; ++axis) {
        entries.emplace_back(Dim * row[node] + axis, Dim * row[node] + axis, 1e3);
      }
    }
  }
  system.whole.resize(Dim * count, Dim * count);
  system.whole.setFromTriplets(entries.begin(), entries.end());
  system.lower = system.whole.triangularView<Eigen::Lower>();
  system.solution = Eigen::VectorXd::LinSpaced(Dim * count, -1.0, 1.0);
  system.right_side = system.whole * system.solution;
  return system;
}

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// `prepare`, `factorise` and `solve` of one solver; made anew for each number of threads.
struct Solver {
  std::function<void()> prepare, factorise;
  std::function<Eigen::VectorXd()> solve;
};

template <class Make>
void report(const char* name, const System& system, const Make& make) {
  Eigen::VectorXd found[2];
  double taken[3] = {};
  for (int threads = 1; threads <= 2; ++threads) {
    set_thread_count(threads);
    Solver solver = make();
    const double begin = seconds();
    solver.prepare();
    const double prepared = seconds();
    solver.factorise();
    const double factorised = seconds();
    found[threads - 1] = solver.solve();
    if (threads == 1) {
      taken[0] = prepared - begin;
      taken[1] = factorised - prepared;
      taken[2] = seconds() - factorised;
    }
  }
  const bool same =
      std::memcmp(found[0].data(), found[1].data(), sizeof(double) * found[0].size()) == 0;
  std::printf("%9lld  %-22s %8.3f %8.3f %8.3f  %8.1e  %s\n",
              static_cast<long long>(system.lower.rows()), name, taken[0], taken[1], taken[2],
              (found[0] - system.solution).norm() / system.solution.norm(), same ? "yes" : "no");
  std::fflush(stdout);
}

template <class Library>
Solver of_library(const SparseMatrix& matrix, const Eigen::VectorXd& right_side) {
  auto solver = std::make_shared<Library>();
  return {[=, &matrix] { solver->analyzePattern(matrix); },
          [=, &matrix] { solver->factorize(matrix); },
          [=, &right_side] { return Eigen::VectorXd(solver->solve(right_side)); }};
}

template <int Dim>
void measure(int cells) {
  const System system = block<Dim>(cells);
  report("Multifrontal", system, [&] {
    auto fronts = std::make_shared<Multifrontal>();
    return Solver{[=, &system] { fronts->analyse(system.lower, system.part_start); },
                  [=, &system] { fronts->factorise(system.lower); },
                  [=, &system] { return fronts->solve(system.right_side); }};
  });
  using LDLT = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower>;
  using Ordered = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;
  using LU = Eigen::SparseLU<SparseMatrix>;
  report("Eigen LDLT, AMD", system,
         [&] { return of_library<LDLT>(system.lower, system.right_side); });
  report("Eigen LDLT, dissection", system,
         [&] { return of_library<Ordered>(system.lower, system.right_side); });
#ifdef BENCH_SUITESPARSE
  using Cholmod = Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower>;
  report("CHOLMOD supernodal", system,
         [&] { return of_library<Cholmod>(system.lower, system.right_side); });
  using UmfPack = Eigen::UmfPackLU<SparseMatrix>;
  report("UMFPACK", system, [&] { return of_library<UmfPack>(system.whole, system.right_side); });
#endif
  report("Eigen SparseLU", system, [&] { return of_library<LU>(system.whole, system.right_side); });
}

}  // namespace

int main(int count, char** values) {
  std::printf("%9s  %-22s %8s %8s %8s  %8s  %s\n", "unknowns", "solver", "analyse", "factor",
              "solve", "error", "same bytes");
  for (int k = 2; k < count; ++k) {
    std::atoi(values[1]) == 3 ? measure<3>(std::atoi(values[k])) : measure<2>(std::atoi(values[k]));
  }
}
