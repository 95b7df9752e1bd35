#include "lapilli/scene/member_types.hpp"

namespace lapilli {

void MemberNames::operator()(const Key& key, AnyMember) { names.emplace_back(key.name); }

}  // namespace lapilli
