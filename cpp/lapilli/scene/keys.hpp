#pragma once

#include <string>

namespace lapilli {

/// Every key of a scene file as Markdown tables: type, unit, allowed values, default, meaning.
std::string keys_as_markdown();

}  // namespace lapilli
