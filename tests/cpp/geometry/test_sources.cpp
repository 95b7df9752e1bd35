#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "geometry/scratch_file.hpp"
#include "lapilli/geometry/number_rows.hpp"
#include "lapilli/geometry/sources.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

namespace {

template <class T>
std::string npy(const std::vector<T>& values, const std::string& type, const std::string& shape,
                const std::string& fortran = "False") {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
  header.resize(118 - 1, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\1\0", 8);
  bytes += static_cast<char>(header.size());
  bytes += '\0';
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  return bytes;
}

}  // namespace

TEST_CASE("points are read with commas, semicolons, spaces, names and comments") {
  const std::vector<double> positions = {0.5, 1, -2e-3, 3, 4, 5};
  for (const std::string& text :
       {std::string("0.5,1,0.25\n-2e-3,3,0.5\n4,5,0.75\n"),
        std::string(
            "# made by hand\nx, y, volume\n0.5 1 0.25\n\n-2e-3;+3;0.5 # second\r\n4\t5 0.75")}) {
    const ScratchFile file(text, ".csv");
    const auto points = read_points(file.path(), 2);
    REQUIRE(points.position == positions);
    REQUIRE(points.volume == std::vector<double>{0.25, 0.5, 0.75});
    REQUIRE(points.spacing == Approx(std::sqrt(0.5)));
    REQUIRE(points.dimension == 2);
  }
  const ScratchFile bare("1\n2\n");
  REQUIRE(read_points(bare.path(), 1, 0.1).volume == std::vector<double>{0.1, 0.1});
  const ScratchFile solid("1 2 3\n4 5 6\n");
  REQUIRE(read_points(solid.path(), 3, 8.0).spacing == Approx(2.0));
}

TEST_CASE("no row is lost to a byte-order mark or quotes") {
  for (const std::string& text :
       {std::string("\xEF\xBB\xBF") + "0.5 1 0.25\n4 5 0.75\n",
        std::string("\"0.5\",\"1\",\"0.25\"\r\n4,5,0.75\r\n"),
        std::string("\xEF\xBB\xBF") + "\"x1\",\"x2\",\"volume\"\n0.5,1,0.25\n4,5,0.75\n"}) {
    const ScratchFile file(text, ".csv");
    const auto points = read_points(file.path(), 2);
    REQUIRE(points.position == std::vector<double>{0.5, 1, 4, 5});
    REQUIRE(points.volume == std::vector<double>{0.25, 0.75});
  }
}

TEST_CASE("columns of points are found by their names, in any order") {
  const std::vector<std::string> units[] = {
      {"", "", ""}, {" [m]", "(m)", " [m^2]"}, {"_m", " (m)", "_m2"}};
  for (const auto& unit : units) {
    std::vector<std::pair<std::string, std::string>> columns = {
        {"x" + unit[0], "0.5"}, {"Y" + unit[1], "1"}, {"volume" + unit[2], "0.25"}};
    std::ranges::sort(columns);
    do {
      for (const std::string start : {"", "# "}) {
        std::string names = start, row;
        for (std::size_t k = 0; k < columns.size(); ++k) {
          names += (k == 0 ? "" : ",") + columns[k].first;
          row += (k == 0 ? "" : ",") + columns[k].second;
        }
        const ScratchFile file(names + "\n" + row + "\n", ".csv");
        INFO(names);
        const auto points = read_points(file.path(), 2);
        CHECK(points.position == std::vector<double>{0.5, 1});
        CHECK(points.volume == std::vector<double>{0.25});
      }
    } while (std::ranges::next_permutation(columns).found);
  }
  const ScratchFile two("y x\n1 0.5\n");
  CHECK(read_points(two.path(), 2, 1.0).position == std::vector<double>{0.5, 1});
  const ScratchFile other("east,north,size\n0.5,1,0.25\n");
  CHECK(read_points(other.path(), 2).position == std::vector<double>{0.5, 1});
  const ScratchFile remark("# the x of all\n0.5,1,0.25\n");
  CHECK(read_points(remark.path(), 2).position == std::vector<double>{0.5, 1});
}

TEST_CASE("columns of points that cannot be told are refused by name") {
  const auto refused = [](const std::string& bytes, const std::string& text) {
    const ScratchFile file(bytes, ".csv");
    INFO(bytes);
    CHECK_THROWS_WITH(read_points(file.path(), 2, 1.0), Contains(text) && Contains(file.path()));
  };
  refused(
      "id,x,y\n0.1,1,2\n",
      "line 1, column 1: 'id' is no column of points in 2 dimensions; allowed are x, y, volume");
  refused("x,y,mass\n1,2,3\n", "line 1, column 3: 'mass' is no column");
  refused("x,y,z\n1,2,3\n", "line 1, column 3: 'z' is no column");
  refused("x,y,volume,T\n1,2,3,4\n", "line 1, column 4: 'T' is no column");
  refused("x,x,volume\n1,2,3\n", "line 1, column 2: 'x' comes twice");
  refused("x,volume\n1,2\n", "line 1: no column is named y");
  refused("x [mm],y [mm],volume\n1,2,3\n",
          "line 1, column 1: 'x [mm]' is in mm; points are given in m");
  refused("x,y,volume [mm^2]\n1,2,3\n", "line 1, column 3: 'volume [mm^2]' is in mm^2");
  refused("x_mm y_mm\n1 2\n", "line 1, column 1: 'x_mm' is in mm");
  refused("x\ty\tvolume\n1\t\t3\n", "line 2: got 2 numbers, the names above are 3");
}

TEST_CASE("an empty cell is refused where it stands") {
  for (const char separator : {',', ';'}) {
    for (std::size_t gap = 0; gap < 3; ++gap) {
      std::string row;
      for (std::size_t column = 0; column < 3; ++column) {
        row +=
            (column == 0 ? std::string() : std::string(1, separator)) + (column == gap ? " " : "1");
      }
      const ScratchFile file("1 2 3\n" + row + "\n", ".csv");
      const std::string text = "line 2, column " + std::to_string(gap + 1) + ": the cell is empty";
      CHECK_THROWS_WITH(read_points(file.path(), 2), Contains(text));
      CHECK_THROWS_WITH(read_points(file.path(), 3, 1.0), Contains(text));
      CHECK_THROWS_WITH(read_two_columns(file.path()), Contains("two columns") || Contains(text));
    }
  }
  const ScratchFile table("0,1\n2,\n");
  CHECK_THROWS_WITH(read_two_columns(table.path()),
                    Contains("line 2, column 2: the cell is empty"));
  const ScratchFile after("0.5,1,0.25\n,,\n");
  CHECK(read_points(after.path(), 2).size() == 1);  // what spreadsheets leave below a table
}

TEST_CASE("a table whose names put the time second, or not in seconds, is refused") {
  const ScratchFile swapped("value,time\n1,0\n2,1\n");
  CHECK_THROWS_WITH(read_two_columns(swapped.path()),
                    Contains("line 1, column 2: times belong into the first column"));
  const ScratchFile hours("time [h],value\n1,0\n2,1\n");
  CHECK_THROWS_WITH(read_two_columns(hours.path()), Contains("times are in s, not in h"));
  const ScratchFile seconds("time [s],value [K]\n1,0\n2,1\n");
  CHECK(read_two_columns(seconds.path()).first == std::vector<double>{1, 2});
}

TEST_CASE("two columns are read, and refused where a row has not two") {
  const ScratchFile file("time, flux\n0, 1\n2, -3e2\n", ".csv");
  const TwoColumns columns = read_two_columns(file.path());
  REQUIRE(columns.first == std::vector<double>{0, 2});
  REQUIRE(columns.second == std::vector<double>{1, -300});
  const ScratchFile three("0 1\n1 2 3\n");
  REQUIRE_THROWS_WITH(read_two_columns(three.path()), Contains("line 2: two columns are needed"));
}

TEST_CASE("points are read from NumPy arrays") {
  const std::vector<double> rows = {0.5, 1, 0.25, 4, 5, 0.75};
  const ScratchFile file(npy(rows, "<f8", "(2, 3)"), ".npy");
  const auto points = read_points(file.path(), 2);
  REQUIRE(points.position == std::vector<double>{0.5, 1, 4, 5});
  REQUIRE(points.volume == std::vector<double>{0.25, 0.75});
  const ScratchFile single(npy(std::vector<float>(rows.begin(), rows.end()), "<f4", "(2, 3)"),
                           ".npy");
  REQUIRE(read_points(single.path(), 2).position == points.position);
}

TEST_CASE("unusable points are refused, naming file and line") {
  const auto refused = [](const std::string& bytes, const std::string& text,
                          const std::string& ending = ".txt", double volume = 0.0) {
    const ScratchFile file(bytes, ending);
    REQUIRE_THROWS_WITH(read_points(file.path(), 2, volume),
                        Contains(text) && Contains(file.path()));
  };
  refused("1 2 3\n1 2 x\n", "line 2, column 3: 'x' is no number");
  refused("x y\nu v\n", "line 2, column 1: 'u' is no number");
  refused("1 y\n1 2\n", "line 1, column 2: 'y' is no number");
  refused("1 2 3\n1 2\n", "line 2: got 2 numbers, the rows before have 3", ".txt", 1.0);
  refused("1 2 3 4\n", "line 1: a point needs 2 coordinates and perhaps a volume, got 4 numbers");
  refused("1\n", "got 1 number");
  refused("1 2\n", "line 1: the file has no column of volumes and no volume was given");
  refused("1 2 3\n\n1 2 0\n", "line 3: the volume must be positive, got 0");
  refused("1 nan 3\n", "line 1: numbers must be finite");
  refused("O.5 0.5 0.01\n0.6 0.6 0.01\n", "line 1, column 1: 'O.5' is no number");
  refused("1e400 0.5 0.01\n", "line 1, column 1: '1e400' is too large");
  refused("1 2 1.0D-2\n", "'1.0D-2' is no number; write the exponent with e");
  refused("2\n1 2 3\n1 2 3\n", "got 1 number; is it a count of rows? leave it out");
  refused("x,y,v,2\n1,2,3\n", "line 1, column 1: 'x' is no number");
  refused("# nothing\n", "the file holds no points");
  REQUIRE_THROWS_WITH(read_points("nowhere.csv", 2),
                      Contains("nowhere.csv: there is no such file"));

  const std::vector<double> rows = {0.5, 1, 0.25, 4, 5, -1};
  refused(npy(rows, "<f8", "(2, 3)"), "row 1: the volume must be positive", ".npy");
  refused(npy(rows, "<f8", "(3, 3)"), "3 x 3 numbers are promised, 6 are held", ".npy");
  refused(npy(rows, "<f8", "(6,)"), "two dimensions in C order", ".npy");
  refused(npy(rows, "<f8", "(2, 3)", "True"), "two dimensions in C order", ".npy");
  refused(npy(rows, "<i8", "(2, 3)"), "must be float64 or float32", ".npy");
  refused("1 2 3\n4 5 6\n 7 8 9", "not a NumPy array file", ".npy");
}
