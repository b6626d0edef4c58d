// Threads and knurls of rough zones, from the spectrum of the surface.
//
// A thread or a knurl is a peak of Σ r·e^{-i(2πfz + mθ)}: |m| ≤ 8 a thread with m starts and the pitch 1/f, its sign
// the hand; more a knurl with m teeth, f = 0 where its ridges are straight. f is refined on the points themselves;
// folded over the phase they give the root, the density of the radii the crest (crest.h).
#pragma once

#include <optional>

#include "engine/core/progress.h"
#include "engine/features/walls/walls.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// The thread or knurl of one rough zone about the radius `about_mm`; none where the spectrum has no peak. Throws
/// Cancelled.
std::optional<ShaftMark> periodicMark(const MeridianCloud& cloud, double from_mm, double to_mm, double about_mm,
                                      double sigma_mm, const Progress& progress = {});

}  // namespace lathelier::features
