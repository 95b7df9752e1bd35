#include "lapilli/core/diagnostics.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "lapilli/core/extensive_unit.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/snake_case.hpp"

namespace lapilli {
namespace {

/// Units in three dimensions; `extensive` ones are per depth in fewer.
struct Known {
  const char* name;  // after the slash; one that ends in _ stands for all that begin with it
  const char* unit;
  bool extensive;
  const char* meaning;
  bool adds_up = false;  // counts what happened: goes on over the stages of a run
};

// A name may begin or go on with others where a pattern has an underscore; the last one counts.
constexpr Known known_diagnostics[] = {
    {"_force_", "N", true,
     "force on an obstacle, or of one body on another (on the second named), a component"},
    {"_torque_", "N m", true, "torque on an obstacle about its centre, a component"},
    {"_work", "J", true, "work of an obstacle on the material so far", true},
    {"_contacts", "", false, "points that an obstacle pushes now"},
    {"_position_", "m", false, "place of the centre of an obstacle, a component"},
    {"_velocity_", "m/s", false, "velocity of the centre of an obstacle, a component"},
    {"_spin_", "rad/s", false, "angular velocity of an obstacle, a component"},
    {"_angle", "rad", false, "angle by which an obstacle has turned"},
    {"_kinetic_energy", "J", true, "kinetic energy of an obstacle"},
    {"surface_area", "m^2", true, "area of the surface that boundary conditions act on"},
    {"free_surface_area", "m^2", true, "area of all free surface of the bodies' shapes"},
    {"area_ratio", "", false,
     "area of the shape over what the nodes found at the start, by which areas are scaled"},
    {"negative_area_share", "", false, "share of negative nodal areas in the surface"},
    {"steps_per_heat_step", "", false,
     "steps of the run that one of heat covers, the mean so far; below 1 where several fit in one"},
    {"time_error", "", false,
     "estimated error of the steps so far, as a share of the span of temperatures"},
    {"implicit_steps", "", false, "implicit steps taken so far", true},
    {"staged_steps", "", false, "explicit steps of many stages taken so far", true},
    {"heat_from_", "J", true, "heat that has passed from one body to another", true},
    {"nodal_stray", "K", false,
     "how far nodes are beyond the temperatures of start and surroundings now"},
    {"liquid_volume", "m^3", true, "volume of what has melted"},
    {"iterations", "", false, "iterations of the last solve"},
    {"residual", "", false, "relative residual of the last solve"},
    {"smallest_pivot", "", false, "smallest pivot of the last factorisation"},
    {"largest_pivot", "", false, "largest pivot of the last factorisation"},
    {"condition_estimate", "", false, "ratio of the largest pivot to the smallest"},
    {"halvings", "", false, "times the last load step was halved"},
    {"deepest_penetration", "m", false, "depth of the deepest point behind a wall"},
    {"largest_strain", "", false, "largest principal strain of any point, of either sign"},
    {"force_of_", "N", true, "force of a wall or support on the material, a component"},
    {"torque_of_", "N m", true, "torque of a wall or support on the material"},
    {"kinetic_energy", "J", true, "kinetic energy of the points"},
    {"elastic_energy", "J", true, "elastic energy stored"},
    {"potential_energy", "J", true, "energy of weight, zero at the origin"},
    {"plastic_dissipation", "J", true, "work dissipated by plastic flow so far", true},
    {"wall_friction", "J", true, "work dissipated by friction on walls so far", true},
    {"wall_impact", "J", true, "kinetic energy lost in impact on walls so far", true},
    {"transfer_loss", "J", true, "kinetic energy lost between points and grid so far", true},
    {"removed_points", "", false, "points that left the grid and were removed so far", true},
    {"removed_mass", "kg", true, "mass of points that left the grid and were removed so far", true},
    {"damping_loss", "J", true, "energy that local damping has taken so far", true},
    {"strain_transfer_loss", "J", true, "elastic energy lost between points and grid so far", true},
    {"expansion_work", "J", true, "work of thermal expansion so far", true},
    {"energy_gained", "J", true, "energy that nothing put in so far; negative: lost", true},
    {"contact_friction", "J", true, "work dissipated by friction between bodies so far", true},
    {"contact_impact", "J", true, "kinetic energy lost where bodies met so far", true},
    {"contact_nodes", "", false, "nodes where bodies push each other now"},
    {"load_work", "J", true, "work of pressures and tractions so far", true},
    {"heat_flow_from_wall_", "W", true, "heat that enters the fluid from a wall now"},
    {"nusselt_number_of_wall_", "", false, "heat flow of a wall over that of pure conduction"},
    {"bond_imbalance", "W", true, "heat that bonds create out of nothing"},
    {"velocity_noise", "", false, "share of the velocity that neighbours do not share"},
    {"least_density_variation", "", false, "least relative deviation of density"},
    {"greatest_density_variation", "", false, "greatest relative deviation of density"},
    {"smallest_spacing", "", false, "least distance of neighbours, in spacings"},
    {"sound_speed", "m/s", false, "sound speed of the weakly compressible fluid"},
    {"family_searches", "", false, "times neighbours were searched so far", true},
};

std::string unit_in(int dimension, const Known& known) {
  return known.extensive ? extensive_unit(known.unit, dimension) : known.unit;
}

const Known* known_as(const std::string& name) {
  const Known* best = nullptr;
  for (const Known& known : known_diagnostics) {
    const std::string pattern = known.name;
    const bool opens = pattern.front() == '_', goes_on = pattern.back() == '_';
    const std::size_t at = name.find(pattern);
    if (pattern == name || (at != std::string::npos && (opens || at == 0) &&
                            (goes_on || (opens && name.ends_with(pattern))))) {
      best = &known;
    }
  }
  return best;
}

void add_balances(const Simulation& simulation, std::vector<Scalar>& all) {
  for (const Balance& balance : simulation.balances()) {
    const std::string name = snake_case(balance.quantity) + "/";
    all.push_back(
        {name + "stored", balance.stored, balance.unit, balance.quantity + " stored now"});
    for (const Balance::Entry& entry : balance.entries) {
      all.push_back({name + "supplied_by_" + snake_case(entry.name), entry.in, balance.unit,
                     balance.quantity + " supplied by " + entry.name + " since the start"});
    }
    all.push_back({name + "residual", balance.residual(), "",
                   "relative error of the balance of " + balance.quantity});
  }
}

/// Smallest and largest of one number per point, over the points of the first bodies.
template <class Number>
std::pair<double, double> range_of(const Points& points, int bodies, const Number& number) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (Index row = 0; row < points.size(); ++row) {
    if (points.body()[static_cast<std::size_t>(row)] < bodies) {
      const double value = number(static_cast<std::size_t>(row));
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  return {least, most};
}

void add_range(const std::string& name, const std::string& unit, const std::string& of,
               std::pair<double, double> range, std::vector<Scalar>& all) {
  all.push_back({name + "/smallest", range.first, unit, "smallest " + of});
  all.push_back({name + "/largest", range.second, unit, "largest " + of});
}

void add_field(const Field& field, const Points& points, int bodies, std::vector<Scalar>& all) {
  const auto width = static_cast<std::size_t>(field.components);
  const auto number = [&](std::size_t row) {
    if (width == 1) {
      return field.values[row];
    }
    double square = 0.0;
    for (std::size_t c = 0; c < width; ++c) {
      const double value = field.values[row * width + c];
      square += (width == 6 && c >= 3 ? 2.0 : 1.0) * value * value;
    }
    return std::sqrt(square);
  };
  add_range(field.name, field.unit, (width == 1 ? "" : "magnitude of ") + field.name,
            range_of(points, bodies, number), all);
}

void add_extent(const Points& points, int bodies, std::vector<Scalar>& all) {
  const auto width = static_cast<std::size_t>(points.dimension());
  for (std::size_t axis = 0; axis < width; ++axis) {
    const auto number = [&](std::size_t row) { return points.position()[row * width + axis]; };
    const std::string name(1, "xyz"[axis]);
    add_range("position_" + name, "m", name + " of a point: where the front is",
              range_of(points, bodies, number), all);
  }
}

void add_diagnostics(const Simulation& simulation, std::vector<Scalar>& all) {
  for (const auto& physics : simulation.physics()) {
    for (const auto& [words, value] : physics->diagnostics()) {
      const std::string name = snake_case(words);
      const Known* known = known_as(name);
      const double earlier = simulation.account().sum(physics->name() + "/" + words);
      all.push_back({physics->name() + "/" + name, value + earlier,
                     known ? unit_in(simulation.points().dimension(), *known) : "",
                     known ? known->meaning : words});
    }
  }
}

}  // namespace

std::string snake_case(const std::string& words) {
  std::string name;
  for (const char letter : words) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isalnum(code) != 0 || code >= 0x80) {
      name += letter;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') {
    name.pop_back();
  }
  return name;
}

bool counts_what_happened(const std::string& words) {
  const Known* known = known_as(snake_case(words));
  return known != nullptr && known->adds_up;
}

std::vector<Scalar> diagnostics_of(Simulation& simulation) {
  for (const auto& physics : simulation.physics()) {
    physics->refresh_output();
  }
  std::vector<Scalar> all;
  add_diagnostics(simulation, all);
  return all;
}

std::vector<Scalar> scalars_of(Simulation& simulation, int bodies) {
  const std::vector<Field> fields = simulation.fields();
  std::vector<Scalar> all;
  add_diagnostics(simulation, all);
  add_balances(simulation, all);
  bool moves = false;
  for (const Field& field : fields) {
    moves |= field.name == "velocity" || field.name == "displacement";
    add_field(field, simulation.points(), bodies, all);
  }
  if (moves) {
    add_extent(simulation.points(), bodies, all);
  }
  return all;
}

std::string diagnostics_as_markdown() {
  std::string text = "| name | unit | meaning |\n|---|---|---|\n";
  const auto row = [&](const std::string& name, const std::string& unit, const std::string& says) {
    text += message("| `", name, "` | ", unit, " | ", says, " |\n");
  };
  for (const Known& known : known_diagnostics) {
    const std::string name = known.name;
    row(name.back() == '_' ? name + "<name>" : name, known.unit, known.meaning);
  }
  row("<quantity>/stored", "J, kg or kg m/s", "heat, energy, momentum or mass stored now");
  row("<quantity>/supplied_by_<name>", "J, kg or kg m/s",
      "what a boundary condition or source supplied so far");
  row("<quantity>/residual", "", "relative error of the balance");
  row("<field>/smallest", "", "least value of a field, or least magnitude");
  row("<field>/largest", "", "greatest value of a field, or greatest magnitude");
  row("position_x/largest", "m", "how far material reaches along an axis: the run-out front");
  return text;
}

}  // namespace lapilli
