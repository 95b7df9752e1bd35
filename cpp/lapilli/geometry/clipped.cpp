#include "lapilli/geometry/clipped.hpp"

#include <algorithm>

namespace lapilli {
namespace {

// The fullest box around `site`, itself excluded; null if there is none above `least`.
BoxPart* fullest_neighbour(std::vector<BoxPart>& boxes, const Sites::Site& site, double least) {
  BoxPart* best = nullptr;
  Sites::Site other;
  for (other[2] = site[2] - 1; other[2] <= site[2] + 1; ++other[2]) {
    for (other[1] = site[1] - 1; other[1] <= site[1] + 1; ++other[1]) {
      for (other[0] = site[0] - 1; other[0] <= site[0] + 1; ++other[0]) {
        const auto found = std::lower_bound(
            boxes.begin(), boxes.end(), other,
            [](const BoxPart& box, const Sites::Site& at) { return visited_before(box.site, at); });
        if (found != boxes.end() && found->site == other && found->part.volume >= least &&
            (best == nullptr || found->part.volume > best->part.volume)) {
          best = &*found;
        }
      }
    }
  }
  return best;
}

}  // namespace

void merge_slivers(std::vector<BoxPart>& boxes, double least) {
  double whole = 0.0, left_out = 0.0;
  for (const BoxPart& box : boxes) {
    const Part& sliver = box.part;
    whole += sliver.volume;
    if (sliver.volume >= least) {
      continue;
    }
    BoxPart* neighbour = fullest_neighbour(boxes, box.site, least);
    if (neighbour == nullptr) {
      left_out += sliver.volume;
      continue;
    }
    Part& part = neighbour->part;
    const double share = sliver.volume / (part.volume + sliver.volume);
    part.centroid += share * (sliver.centroid - part.centroid);
    part.volume += sliver.volume;
    part.is_whole = false;
  }
  std::erase_if(boxes, [&](const BoxPart& box) { return box.part.volume < least; });
  if (left_out > 0.0) {
    for (BoxPart& box : boxes) {
      box.part.volume *= whole / (whole - left_out);
    }
  }
}

double volume_of(const std::vector<BoxPart>& boxes) {
  double sum = 0.0;
  for (const BoxPart& box : boxes) {
    sum += box.part.volume;
  }
  return sum;
}

}  // namespace lapilli
