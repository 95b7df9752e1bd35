#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <ctime>
#include <numbers>
#include <sstream>

#include "geometry/meshes.hpp"
#include "geometry/random_points.hpp"
#include "geometry/scratch_file.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/geometry/stl_file.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

namespace {

std::string as_text(const Mesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "solid body\n";
  for (const auto& row : mesh.triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (int vertex : row) {
      const auto& at = mesh.vertices[vertex];
      text << "  vertex " << at[0] << " " << at[1] << " " << at[2] << "\n";
    }
    text << "endloop\nendfacet\n";
  }
  text << "endsolid body\n";
  return text.str();
}

std::string as_binary(const Mesh& mesh) {
  // Many programs start binary files with "solid" as well.
  std::string bytes = "solid but binary";
  bytes.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& row : mesh.triangles) {
    bytes.append(12, '\0');
    for (int vertex : row) {
      for (double coordinate : mesh.vertices[vertex]) {
        const auto value = static_cast<float>(coordinate);
        bytes.append(reinterpret_cast<const char*>(&value), 4);
      }
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

Mesh from_file(const std::string& path) {
  Mesh mesh;
  mesh.file = path;
  return mesh;
}

void require_like_box(const Mesh& mesh, const Box& box) {
  mesh.check(3);
  for (const Vec3& x : random_points(2000, 3, {Vec3(-1, -1, -1), Vec3(2, 2, 2)})) {
    REQUIRE(mesh.distance(x) == Approx(box.distance(x)).margin(1e-14));
    if (box.distance(x) > 0) {
      REQUIRE((mesh.gradient(x) - box.gradient(x)).norm() < 1e-9);
    }
  }
}

}  // namespace

TEST_CASE("a cube of triangles has the distances of a box, whichever way they are turned") {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  require_like_box(cube_mesh(), box);
  Mesh inside_out = cube_mesh();
  for (auto& row : inside_out.triangles) {
    std::swap(row[1], row[2]);
  }
  require_like_box(inside_out, box);
  REQUIRE(inside_out.gradient(Vec3(1, 0.3, 0.4)) == Vec3(1, 0, 0));
  REQUIRE(cube_mesh().surface == nullptr);
  REQUIRE(inside_out.surface->volume() == Approx(1.0).epsilon(1e-15));
}

TEST_CASE("a fine ball of triangles has the distances of a full search and of the sphere") {
  const Mesh mesh = ball_mesh(4);
  mesh.check(3);
  REQUIRE(mesh.triangles.size() == 2048);
  const auto& surface = *mesh.surface;
  for (const Vec3& x : random_points(300, 3, {Vec3(-2, -2, -2), Vec3(2, 2, 2)})) {
    // Sagitta of the longest edge, about 0.14: below 0.14^2 / 6.
    REQUIRE(mesh.distance(x) == Approx(x.norm() - 1).margin(4e-3));
    // The nearest place is no nearer than to any plane of a triangle facing x, and lies on one.
    const auto nearest = surface.nearest(x);
    double least = 1e300;
    for (const auto& row : mesh.triangles) {
      for (int vertex : row) {
        least = std::min(least, (place(mesh.vertices[vertex]) - x).norm());
      }
    }
    REQUIRE(std::sqrt(nearest.squared) <= least);
    REQUIRE((nearest.place - x).norm() == Approx(std::sqrt(nearest.squared)));
    REQUIRE(std::abs(mesh.distance(nearest.place)) < 1e-14);
  }
}

TEST_CASE("volumes of finer balls approach the sphere's at second order") {
  double error[3];
  for (int level = 2; level < 5; ++level) {
    const Mesh mesh = ball_mesh(level);
    mesh.check(3);
    error[level - 2] = 4 * std::numbers::pi / 3 - mesh.surface->volume();
  }
  // Flat triangles: the error is proportional to the edge squared.
  REQUIRE(std::log2(error[0] / error[1]) == Approx(2.0).margin(0.1));
  REQUIRE(std::log2(error[1] / error[2]) == Approx(2.0).margin(0.03));
}

TEST_CASE("inside is told right for rays through edges and vertices") {
  const Mesh mesh = ball_mesh(3);
  mesh.check(3);
  // From these places rays to the vertices and along symmetry planes are the natural accidents.
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0.25, 0.25, 0.25), Vec3(0, 0.9, 0)}) {
    REQUIRE(mesh.distance(x) < 0);
  }
  const Mesh box = cube_mesh();
  box.check(3);
  for (int i = 1; i < 8; ++i) {
    REQUIRE(box.distance(Vec3(i / 8.0, i / 8.0, i / 8.0)) < 0);
    REQUIRE(box.distance(Vec3(-i / 8.0, i / 8.0, i / 8.0)) > 0);
  }
}

TEST_CASE("overlapping parts are joined") {
  Mesh mesh = cube_mesh();
  const Mesh other = cube_mesh(0.5, 1.5);
  for (const auto& vertex : other.vertices) {
    mesh.vertices.push_back(vertex);
  }
  for (auto row : other.triangles) {
    for (int& vertex : row) {
      vertex += 8;
    }
    mesh.triangles.push_back(row);
  }
  mesh.check(3);
  const Shape both = Union{{Box{{0, 0, 0}, {1, 1, 1}}, Box{{0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}}}};
  for (const Vec3& x : random_points(2000, 3, {Vec3(-1, -1, -1), Vec3(2, 2, 2)})) {
    REQUIRE(covers(mesh, x) == covers(both, x));
  }
}

TEST_CASE("STL files, text and binary, give back the mesh") {
  const Mesh given = ball_mesh(2);
  for (const std::string& bytes : {as_text(given), as_binary(given)}) {
    const ScratchFile file(bytes, ".stl");
    const Triangles read = read_stl(file.path());
    REQUIRE(read.vertices.size() == given.vertices.size());
    REQUIRE(read.rows.size() == given.triangles.size());
    for (std::size_t k = 0; k < read.rows.size(); ++k) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec3 back = read.vertices[read.rows[k][corner]];
        // Single precision keeps 2^-24.
        REQUIRE((back - place(given.vertices[given.triangles[k][corner]])).norm() < 1.1e-7);
      }
    }
  }
  const ScratchFile file(as_binary(cube_mesh()));
  Mesh scaled = from_file(file.path());
  scaled.scale = 0.001;
  scaled.check(3);
  REQUIRE(scaled.surface->volume() == Approx(1e-9));
  REQUIRE(scaled.bounds().upper == Vec3::Constant(0.001));
}

TEST_CASE("files of other programs are read: rounding, capitals, blanks, trailing bytes, copies") {
  const auto volume_of = [](const std::string& bytes) {
    const ScratchFile file(bytes, ".stl");
    const Mesh mesh = from_file(file.path());
    mesh.check(3);
    return mesh.surface->volume();
  };
  std::string text = as_text(cube_mesh());
  REQUIRE(volume_of("\xEF\xBB\xBF" + text) == Approx(1.0));
  REQUIRE(volume_of("  \n " + text) == Approx(1.0));
  std::string capitals = text;
  for (char& letter : capitals) {
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  }
  REQUIRE(volume_of(capitals) == Approx(1.0));
  REQUIRE(volume_of(as_binary(cube_mesh()) + '\0') == Approx(1.0));
  Mesh twice = cube_mesh();
  twice.triangles.push_back(twice.triangles.front());
  REQUIRE(volume_of(as_binary(twice)) == Approx(1.0));
  // One corner of one triangle off by less, and by more, than 1e-7 of the size.
  const auto shifted = [&](const std::string& by) {
    std::string other = text;
    const std::size_t at = other.find("vertex 1 1 1");
    return volume_of(other.replace(at, 12, "vertex 1 1 " + by));
  };
  REQUIRE(shifted("1.0000000000000002") == Approx(1.0));
  REQUIRE(shifted("1.0000001") == Approx(1.0));
  REQUIRE_THROWS_WITH(shifted("1.000001"), Contains("not closed"));
}

TEST_CASE("a mesh is filled like the box it is") {
  const Lattice lattice{Vec3::Zero(), 0.25, 2};
  REQUIRE(fill(cube_mesh(), lattice, {}, 3).position ==
          fill(Box{{0, 0, 0}, {1, 1, 1}}, lattice, {}, 3).position);
  FillOptions options;
  options.clip = true;
  const auto points = fill(cube_mesh(0.03, 0.97), lattice, options, 3);
  double sum = 0.0;
  for (double volume : points.volume) {
    sum += volume;
  }
  REQUIRE(sum == Approx(std::pow(0.94, 3)).epsilon(1e-13));
}

TEST_CASE("unusable meshes are refused, naming the place") {
  const auto refused = [](const Mesh& mesh, const std::string& text) {
    REQUIRE_THROWS_WITH(check(mesh, 3), Contains(text));
  };
  Mesh mesh = cube_mesh();
  mesh.triangles.pop_back();
  refused(mesh, "mesh: the surface is not closed");
  refused(mesh, "edge (1, 1, 0) to (1, 0, 1) lacks its other triangle (3 such edges)");
  mesh = cube_mesh();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  refused(mesh, "turned inside out: edge");
  mesh = cube_mesh();
  mesh.triangles[2][1] = 8;
  refused(mesh, "triangle 2 names vertex 8, there are vertices 0 to 7");
  mesh = cube_mesh();
  mesh.triangles[2].pop_back();
  refused(mesh, "triangle 2 needs 3 vertices, got 2");
  mesh = cube_mesh();
  mesh.vertices[1] = {0, 1};
  refused(mesh, "vertex 1 needs 3 numbers, got 2");
  mesh = cube_mesh();
  mesh.scale = 0;
  refused(mesh, "mesh: scale must be positive");
  refused(Mesh{}, "give a file, or vertices and triangles");
  mesh = cube_mesh();
  mesh.file = "x.stl";
  refused(mesh, "not both");
  refused(from_file("nowhere.stl"), "nowhere.stl: there is no such file");
  REQUIRE_THROWS_WITH(check(cube_mesh(), 2), Contains("mesh needs a grid of 3 dimensions"));
  REQUIRE_THROWS_WITH(cube_mesh().distance(Vec3::Zero()), Contains("call check(shape, 3) first"));
}

// The distance of a place on a face is the rounding of its coordinates, and no walk makes it less.
TEST_CASE("to project what lies on a mesh costs no more than what does not") {
  const Shape ball = ball_mesh(4);
  check(ball, 3);
  const auto seconds = [&](std::vector<Vec3>& places) {
    const std::clock_t begun = std::clock();
    for (Vec3& x : places) {
      const Vec3 at = project(ball, x);
      REQUIRE(std::abs(distance(ball, at)) < 1e-15);
      x = at;
    }
    return static_cast<double>(std::clock() - begun);
  };
  std::vector<Vec3> places = random_points(2000, 3, Bounds{Vec3(-1, -1, -1), Vec3(1, 1, 1)});
  const double off = seconds(places), on = seconds(places);
  REQUIRE(on < 2.0 * off);
}

TEST_CASE("broken STL files are refused, naming file and line") {
  const auto refused = [](const std::string& bytes, const std::string& text) {
    const ScratchFile file(bytes);
    REQUIRE_THROWS_WITH(read_stl(file.path()), Contains(text) && Contains(file.path()));
  };
  refused("P2 1 1 1 1", "not an STL file, or cut short");
  refused(as_binary(cube_mesh()).substr(0, 300), "not an STL file, or cut short");
  refused("solid\nfacet\nouter loop\nvertex 0 0 zero\n", ":4: a vertex needs three numbers");
  refused("solid\nfacet\nvertex 0 0 1\nendloop\n", ":4: a facet needs three vertices, got 1");
  refused("solid\nfacet\nvertex 0 0 1\n", "ends within a facet");
  std::string bytes = as_binary(cube_mesh());
  const float nan = std::nanf("");
  std::memcpy(bytes.data() + 84 + 50 + 12, &nan, 4);
  refused(bytes, "a vertex of triangle 1 is not finite");
}
