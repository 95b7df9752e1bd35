#include "lapilli/mpm/heat/shared_stencil.hpp"

#include <catch2/catch.hpp>

#include "lapilli/geometry/random.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

/// The part of a body that lies anywhere on a grid of unit cells.
template <int Dim>
HeatPart<Dim> part_of(const Shape& shape, ShapeFunction function) {
  const Grid<Dim> grid(Vec<Dim>::Constant(-8.0), Vec<Dim>::Constant(8.0), 1.0);
  HeatBody body = scenes::unit_body(Dim);
  body.shape = shape;
  HeatProblem<Dim> problem{grid, function, {body}, {}, {}, false};
  std::vector<SurfaceFound> found;
  const Points points(Dim);
  auto parts = make_parts<Dim>(points, problem, found);
  return std::move(parts.front());
}

template <int Dim>
std::vector<double> times(const HeatPart<Dim>& part, const std::vector<double>& x) {
  std::vector<double> y(x.size(), 0.0);
  part.conduction->multiply(x.data(), [&](Index place, const auto& product) {
    std::copy(product.begin(), product.end(), y.begin() + place);
  });
  return y;
}

double dot(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sum += x[k] * y[k];
  }
  return sum;
}

template <int Dim>
void check_part(const Shape& shape, ShapeFunction function) {
  const HeatPart<Dim> part = part_of<Dim>(shape, function);
  const auto size = static_cast<std::size_t>(part.rows->size());
  Random random(3);
  std::vector<double> x(size, 0.0), z(size, 0.0), even(size, 0.0);
  std::vector<Index> number(size, -1);
  Index known = 0, shared = 0;
  for (const auto& row : part.rows->rows()) {
    for (Index place = row.shift + row.begin; place < row.shift + row.end; ++place) {
      if (part.conduction->kind(place) != SharedStencil<Dim>::nobody) {
        x[place] = random.uniform(-1.0, 1.0);
        z[place] = random.uniform(-1.0, 1.0);
        even[place] = 287.3;
        number[place] = known++;
        shared += part.conduction->kind(place) >= 0 ? 1 : 0;
      }
    }
  }
  CHECK(shared > known / 20);
  const std::vector<double> of_x = times(part, x);
  CHECK(dot(z, of_x) == Approx(dot(x, times(part, z))).epsilon(1e-12));
  CHECK(dot(x, of_x) > 0.0);
  const std::vector<double> of_even = times(part, even);
  CHECK(std::all_of(of_even.begin(), of_even.end(), [](double value) { return value == 0.0; }));

  std::vector<Eigen::Triplet<double>> lower;
  part.conduction->append_triplets(number, 1.0, lower);
  Eigen::SparseMatrix<double> triangle(known, known);
  triangle.setFromTriplets(lower.begin(), lower.end());
  Eigen::VectorXd some(known);
  for (std::size_t place = 0; place < size; ++place) {
    if (number[place] >= 0) {
      some[number[place]] = x[place];
    }
  }
  const Eigen::VectorXd same = triangle.selfadjointView<Eigen::Lower>() * some;
  double difference = 0.0;
  for (std::size_t place = 0; place < size; ++place) {
    if (number[place] >= 0) {
      difference = std::max(difference, std::abs(same[number[place]] - of_x[place]));
    }
  }
  CHECK(difference <= 1e-13);
}

TEST_CASE("Rows shared by inner nodes make the same symmetric operator") {
  for (const ShapeFunction function :
       {ShapeFunction::linear, ShapeFunction::gimp, ShapeFunction::bspline}) {
    check_part<1>(Box{{-5.7}, {6.1}}, function);
    check_part<2>(Disk{{0.13, 0.21}, 6.0}, function);
    check_part<3>(Box{{-4.1, -5.0, -4.7}, {5.2, 4.4, 5.0}}, function);
  }
}

}  // namespace
}  // namespace lapilli
