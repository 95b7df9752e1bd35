#pragma once

#include <string_view>

#include "lapilli/core/note.hpp"

namespace lapilli {

/// A kind of note: the code that never changes, when it is said, and what to do.
struct NoteKind {
  std::string_view code, when, advice;
};

/// Every kind that `check`, a run or a study can say. The manual lists them from here.
inline constexpr NoteKind note_kinds[] = {
    {"scene.no-effect", "A setting is given that nothing reads in this scene.",
     "Take it out, or set what it needs; the note says what that is."},
    {"scene.not-built", "`check` describes a large scene by its bounds and does not build it.",
     "Nothing: points, memory and time are estimates, and notes that need the points are missing."},
    {"stages.cannot-begin",
     "A later stage cannot begin from the state at the start of the run, which is all `check` has.",
     "Run the stages before it; where the reason has to do with the scene, mend it first."},

    {"bodies.volume", "The points of a body hold another volume than its shape.",
     "`fill = \"exact\"`, or smaller cells."},
    {"bodies.packed-points",
     "The volumes of points that were given exceed the box around them: they overlap.",
     "Look at the unit of volumes and positions."},

    {"heat.no-boundaries", "No boundary condition of heat is given: all surfaces are insulated.",
     "Add `[[heat.boundaries]]`, if that is not meant."},
    {"heat.celsius", "Surfaces radiate, and all temperatures look like degrees Celsius.",
     "Say `heat.temperature_unit = \"celsius\"` or `\"kelvin\"`."},
    {"heat.surface-of-points",
     "A body is known by its points alone, and the area of its surface does not converge.",
     "Give its shape."},
    {"heat.start-table",
     "The temperature at the start is a table in time, of which one value counts.",
     "Give a number; what holds a temperature later is a boundary condition."},
    {"heat.melting-point-start", "A body starts exactly at its melting point, and solid.",
     "Set the temperature a little above to start liquid."},
    {"heat.conductivity-axes",
     "A conductivity that differs between axes stays along those of the grid while the body is "
     "turned.",
     "Give the conductivity of the turned body along the axes of the grid."},
    {"heat.strong-convection",
     "The coefficient of an exchange is large beside conductivity over cell, on bodies that deform "
     "or are known by their points.",
     "Smaller cells, or a prescribed temperature."},
    {"heat.held-part",
     "A temperature is held on a part of the surface of bodies that deform: heat crowds at its "
     "ends.",
     "Smaller cells; the note says how far off the heat is."},
    {"heat.narrow-hold",
     "A temperature is held, or all but, on a strip of the surface a few cells wide.",
     "Smaller cells; the note says how far off the heat is."},
    {"heat.region-below",
     "The region of a condition ends less than a third of a cell below a face that it runs along, "
     "and has it.",
     "Let it end beyond the face, or further below."},
    {"heat.few-cells",
     "A body is heated or cooled from within, and so thin that cells do not resolve how its "
     "temperature rises.",
     "Smaller cells; the note says how far off the rise is."},
    {"heat.shallow", "A run ends before heat has come as deep as the cells at the surface.",
     "The cells that the note names, or a later end."},
    {"heat.held-side-by-side",
     "Two temperatures are held side by side on a body whose conductivity varies.",
     "Let one end a cell before the other."},
    {"heat.crossing",
     "Conditions of different temperature meet on a surface: heat passes straight from one to the "
     "other within less than a cell, and the heat of each alone is off.",
     "Trust the sum of both; smaller cells there."},
    {"heat.flux-beside",
     "A flux ends beside a condition that comes near to holding the surface, to which part of it "
     "passes straight.",
     "Smaller cells there; the note says how far off the heat is."},
    {"heat.unlike-contact",
     "A body that moves touches one that conducts fifty times better, or more.",
     "Smaller cells, so that heat is a few of them deep."},
    {"heat.common-nodes",
     "Bodies that conduct differently share nodes as they move: each face passes too much heat.",
     "Smaller cells, or `contact = \"frictional\"` between them."},
    {"heat.slanted-interface",
     "A body touches one that conducts much better, at an angle to the grid.",
     "More cells across it, or an entry in `[[heat.contacts]]`."},
    {"heat.drawn-gap", "Two bodies are apart by so little that the gap looks like rounding.",
     "Move them together, or apart."},
    {"heat.bridged-gap", "Heat passes a gap whose sides lie in cells that share a node.",
     "Smaller cells, or a wider gap."},
    {"heat.functions-in-long-steps",
     "Long steps may miss what a function in Python does for a short time.",
     "A table in place of the function, or `time_integration = \"explicit\"`."},
    {"heat.time-error", "The error of the time integration is estimated above its tolerance.",
     "Compare with a shorter `time.step`."},
    {"motion.long-step", "A step given is too long for the motion past conditions in space.",
     "Leave `time.step` out, or give at most what the note says."},

    {"dynamics.no-walls", "No face of the grid is a wall: a point that leaves it stops the run.",
     "Add `[[dynamics.grid_boundaries]]`, or `outside = \"remove\"`."},
    {"dynamics.damping-transfer", "The transfer damps motion by an amount for each step.",
     "`transfer = \"blended_apic\"`."},
    {"dynamics.damping-usl", "`stress_update = \"usl\"` damps what vibrates.",
     "`stress_update = \"musl\"`."},
    {"dynamics.damping-bspline", "B-spline functions damp what vibrates.",
     "`grid.shape_function = \"gimp\"`."},
    {"dynamics.no-affine-part", "With linear functions the default transfer lets spin fade.",
     "`grid.shape_function = \"gimp\"`."},
    {"dynamics.few-cells",
     "A body is fewer than eight cells across, or fewer than 28 and may bounce.",
     "Smaller cells; or compare with them to see what this costs."},
    {"dynamics.few-points", "A body has fewer points per cell than the default transfer needs.",
     "Four points per cell in the plane, eight in space."},
    {"dynamics.obstacle-center", "An obstacle turns about the origin of the grid.",
     "Give its `center`."},
    {"dynamics.hanging-energy", "What hangs from an obstacle that holds gains energy.",
     "`local_damping`, or let bodies part from it."},
    {"dynamics.obstacle-end",
     "An obstacle that moves along a face of the grid ends less than a cell from it.",
     "Draw it onto the face or through it, or leave two cells."},
    {"dynamics.inside-obstacle", "Material has passed into an obstacle.",
     "A `roller` face or one of less friction where the obstacle runs along one, or smaller "
     "cells."},
    {"dynamics.near-grid-face",
     "A body starts within cells of a face of the grid, whose nodes hold it before it touches.",
     "Let it touch, or put an obstacle in place of the face."},
    {"dynamics.falls-on-grid-face",
     "A body falls onto a face of the grid, which stops it up to a cell early.",
     "An obstacle of the kind `half_space`."},
    {"dynamics.k0-beyond-strength", "The stress at the start is more than the soil bears.",
     "A `k0` within the range in the note."},
    {"dynamics.open-energy", "The balance of energy does not close.",
     "A smaller `courant`, smaller cells, more points per cell; else treat energies as rough."},
    {"dynamics.gained-energy", "The motion gains energy that nothing put in.",
     "The default transfer, stress update and functions, or a smaller `dynamics.courant`."},
    {"dynamics.large-elastic-strain", "Elastic strains are beyond what the law is good for.",
     "A stiffer material, if that is not meant."},
    {"dynamics.region-left", "The material has moved out of the region of a load.",
     "A larger region, or one that the load follows."},
    {"dynamics.points-removed", "Points left the grid and were removed.",
     "A larger grid, if their mass matters."},

    {"quasi_static.lattice-fill", "A body is filled by a lattice, and cut cells are rough.",
     "`fill = \"exact\"`."},
    {"quasi_static.empty-cells", "A wall that moves into cells without points lets go.",
     "`hold_empty_cells = true`."},
    {"quasi_static.support-off", "A support lies off the bodies that it holds.",
     "Move it to their surface."},
    {"quasi_static.bridged-gap", "Stress passes a gap whose sides lie in cells that share a node.",
     "Smaller cells, or a wider gap."},
    {"quasi_static.stalled", "Newton's method stopped above its tolerance in a load step.",
     "Look at the share in the note: is it small enough for you?"},
    {"quasi_static.large-strain", "Strains are beyond what small strains are good for.",
     "Less load, a stiffer material, or `[dynamics]`."},
    {"quasi_static.coarse", "The cells are coarse for the stresses.", "Halve `grid.cell`."},
    {"quasi_static.blurred-face", "Two bodies of different stiffness share cells.",
     "Put their face on a line of the grid, or take smaller cells."},
    {"quasi_static.crossed-cells", "Points crossed cells with linear functions.",
     "`grid.shape_function = \"gimp\"`."},

    {"peridynamics.no-walls", "Nothing holds the fluid.", "Add `[[peridynamics.walls]]`."},
    {"peridynamics.thin-body", "The bonds of some points miss a part of their surroundings.",
     "Smaller cells where the body is thin, or `laplacian = \"corrected\"`."},
    {"peridynamics.comparison-laplacian", "The operator is one for comparison with the paper.",
     "Leave `laplacian` out."},
    {"peridynamics.held-end", "A wall that holds a temperature ends within a side.",
     "Smaller cells; the note says how far off the heat is."},
    {"peridynamics.large-expansion",
     "The fluid expands by more than buoyancy that is proportional to temperature allows.",
     "Look at the temperatures and `thermal_expansion`; are some in degrees Celsius?"},
    {"peridynamics.coarse", "The points are too few for the layers of the flow.",
     "The cell that the note names."},
    {"peridynamics.coarse-velocity", "The points are too few for a flow without heat.",
     "The cell that the note names."},

    {"run.fails-soon", "The first steps, which `check` takes, fail.", "What the message says."},
    {"run.index-rebuilt", "The index of the frames was lost and is made anew.", "Nothing."},
    {"run.older-checkpoint", "The last checkpoint is damaged, and the one before it was taken.",
     "Nothing: the steps between are computed again."},

    {"study.cell-fitted", "A cell that does not divide the grid was replaced by the nearest.",
     "Nothing, or give cells that divide it."},
    {"study.grid-grown", "The grid was enlarged so that the cell divides it.", "Nothing."},
    {"study.finer-reference", "Errors are those against a finer run of the same scene.",
     "Give `--reference` where there is a better one."},
    {"study.nothing-kept", "Rows are not kept: a function cannot be compared with another.",
     "Put tables in place of functions to go on where a study was stopped."},
};

/// Whether every code is there once.
consteval bool codes_differ() {
  for (const NoteKind& one : note_kinds) {
    for (const NoteKind& other : note_kinds) {
      if (&one != &other && one.code == other.code) {
        return false;
      }
    }
  }
  return true;
}
static_assert(codes_differ(), "two kinds of notes have one code");

consteval NoteCode::NoteCode(const char* code) : code_(code) {
  for (const NoteKind& kind : note_kinds) {
    if (kind.code == code_) {
      return;
    }
  }
  throw "give the note an entry in the list above";
}

/// A note of a kind, its words made of parts as those of message().
template <class... Parts>
Note note(NoteCode code, const Parts&... parts) {
  return {code, message(parts...)};
}

}  // namespace lapilli
