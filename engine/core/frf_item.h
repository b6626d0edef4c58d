// A receptance as an item of the project: one panel measures or computes it, another cuts with it.
#pragma once

#include <optional>

#include "engine/core/frf.h"
#include "engine/core/value.h"

namespace lathelier {

inline constexpr const char* frfItem = "frf";  ///< kind of the item

/// name, frequency_hz, real_mm_N, imag_mm_N, and coherence and noise_mm_N where they are known. Precondition: a
/// receptance whose values are finite. Error linesTooMany for more lines than a project file holds.
Values toValues(const Frf& frf);

/// The same back; nothing when the values are not those of a receptance: lists of different lengths, lines that do not
/// ascend from 0 or more.
std::optional<Frf> frfOf(const Values& values);

}  // namespace lathelier
