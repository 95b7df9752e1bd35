#include "lapilli/peridynamics/held_edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace lapilli {
namespace {

constexpr double lost = 0.2;  // spacings an end
constexpr double flat = 0.9;  // cosine between normals on one side

/// Whether two walls hold the surface at one temperature.
bool hold_alike(const WallSurface& walls, int one, int other) {
  if (other < 0) {
    return false;
  }
  const FluidWallSettings &a = walls.walls()[one].settings, &b = walls.walls()[other].settings;
  return b.heat == WallHeat::temperature && a.temperature.is_constant() &&
         b.temperature.is_constant() && a.temperature.at(0.0) == b.temperature.at(0.0);
}

bool has_held(const std::vector<BoundaryPiece>& pieces, const WallSurface& walls, int wall) {
  return std::any_of(pieces.begin(), pieces.end(), [&](const BoundaryPiece& other) {
    return other.wall == wall || hold_alike(walls, wall, other.wall);
  });
}

/// Whether the side that a piece lies in goes on without its temperature in these pieces.
bool goes_on(const std::vector<BoundaryPiece>& pieces, const WallSurface& walls,
             const BoundaryPiece& held) {
  return std::any_of(pieces.begin(), pieces.end(), [&](const BoundaryPiece& other) {
    return other.wall != held.wall && !hold_alike(walls, held.wall, other.wall) &&
           other.normal.dot(held.normal) > flat;
  });
}

}  // namespace

std::vector<double> lost_at_ends(const FluidSurface& surface, const WallSurface& walls) {
  std::map<FluidSurface::BoxIndex, std::size_t> number;
  for (std::size_t b = 0; b < surface.boxes.size(); ++b) {
    number[surface.box_of(surface.boxes[b] + Vec3::Constant(0.5 * surface.side))] = b;
  }
  std::vector<double> area(walls.walls().size(), 0.0), ends(area);
  for (const auto& [place, b] : number) {
    std::vector<char> ends_here(area.size(), 0);
    for (const BoundaryPiece& piece : surface.pieces[b]) {
      if (piece.wall < 0 || walls.walls()[piece.wall].settings.heat != WallHeat::temperature) {
        continue;
      }
      area[piece.wall] += piece.area;
      bool found = goes_on(surface.pieces[b], walls, piece);
      for (int side = 0; side < 2 * surface.dimension && !found; ++side) {
        FluidSurface::BoxIndex next = place;
        next[static_cast<std::size_t>(side / 2)] += side % 2 == 0 ? -1 : 1;
        const auto at = number.find(next);
        found = at != number.end() && !has_held(surface.pieces[at->second], walls, piece.wall) &&
                goes_on(surface.pieces[at->second], walls, piece);
      }
      ends_here[piece.wall] = ends_here[piece.wall] || found;
    }
    for (std::size_t k = 0; k < ends.size(); ++k) {
      ends[k] += ends_here[k] ? std::pow(surface.side, surface.dimension - 1) : 0.0;
    }
  }
  std::vector<double> share(area.size(), 0.0);
  for (std::size_t k = 0; k < area.size(); ++k) {
    share[k] = area[k] > 0.0 ? lost * ends[k] / area[k] : 0.0;
  }
  return share;
}

}  // namespace lapilli
