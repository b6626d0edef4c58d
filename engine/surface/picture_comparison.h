// Two pictures side by side: one scale, one direction, one size. Different cuts share no texture, so that they are not
// laid on each other point by point unless phase correlation finds one surface in both.
// Source: C. D. Kuglin and D. C. Hines, "The phase correlation image alignment method", 1975.
#pragma once

#include <vector>

#include "engine/surface/surface.h"

namespace lathelier::surface {

/// A response of phase correlation above it means the same surface; different surfaces have about 0.03.
inline constexpr double sameSurface = 0.3;

/// The flattened pictures at the coarsest scale among them (mm per pixel; without scales, pixels of the files), the
/// feed pointing right, all of the size of the smallest.
struct AlignedPictures {
    double mm_per_px = 0;        ///< common scale; 0: not known
    std::vector<Grid> pictures;  ///< in the order of the images
};

/// `shift`: of the second picture against the first, in common pixels: it is taken off, so that what both show lies in
/// one place. What the second does not reach is 0.
AlignedPictures aligned(const std::vector<ImageMarks>& images, Vector shift = {});

/// Of two pictures or more. Notes sameLightingAssumed, notRegistered.
SurfaceComparison compared(const std::vector<ImageMarks>& images, Notes& notes);

}  // namespace lathelier::surface
