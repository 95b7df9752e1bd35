#pragma once

#include <string>

namespace lapilli {

/// The keys of a scene file as Markdown tables: type, unit, allowed values, default, meaning. With
/// a `section` ("heat", "heat.boundaries", "shape", "annulus") those of its tables only; throws
/// std::invalid_argument naming the nearest one where there is none. "history" lists what is
/// recorded in time.
std::string keys_as_markdown(const std::string& section = "");

}  // namespace lapilli
