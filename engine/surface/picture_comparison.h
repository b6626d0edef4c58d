// Two pictures side by side: one scale, one direction, one size. Different cuts have no common texture, so that
// pictures are registered only if phase correlation shows the same surface. Source: C. D. Kuglin and D. C. Hines, "The
// phase correlation image alignment method", 1975.
#pragma once

#include <vector>

#include "engine/surface/surface.h"

namespace lathelier::surface {

/// Response of phase correlation above which both show the same surface; different surfaces have about 0.03.
inline constexpr double sameSurface = 0.3;

/// The flattened pictures at the coarsest scale among them (mm per pixel; without scales, pixels of the files), the
/// feed pointing right, all cropped to the size of the smallest.
struct AlignedPictures {
    double mm_per_px = 0;        ///< common scale; 0: not known
    std::vector<Grid> pictures;  ///< in the order of the images
};

/// `shift`: of the second picture relative to the first, in common pixels; it is compensated. Pixels outside the second
/// are 0.
AlignedPictures aligned(const std::vector<ImageMarks>& images, Vector shift = {});

/// Of two pictures or more. Notes sameLightingAssumed, notRegistered.
SurfaceComparison compared(const std::vector<ImageMarks>& images, Notes& notes);

}  // namespace lathelier::surface
