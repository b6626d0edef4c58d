// A measured profile as an item of the project: one panel cuts it out of its data, another judges its roundness.
#pragma once

#include <optional>

#include "engine/core/profile.h"
#include "engine/core/value.h"

namespace lathelier {

inline constexpr const char* profileItem = "profile";  ///< kind of the item

/// name, x_mm, y_mm.
Values toValues(const Profile& profile);

/// The same back; nothing when the values are not those of a profile.
std::optional<Profile> profileOf(const Values& values);

}  // namespace lathelier
