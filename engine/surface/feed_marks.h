// The feed marks of a turned surface: the line of the spectrum with the best comb of harmonics.
#pragma once

#include <optional>
#include <vector>

#include "engine/surface/grid.h"
#include "engine/surface/significance.h"
#include "engine/surface/spectrum.h"

namespace lathelier::surface {

/// The comb of the feed marks in a picture.
struct FeedComb {
    Vector frequency{};       ///< of its first line, cycles per pixel
    double significance = 0;  ///< of the first line
    double amplitude = 0;     ///< of the first line, in units of the flattened picture
    double comb = 0;          ///< sum of the amplitudes of its lines 1 to 5
};

/// Of the `peaks` the one with the best comb. `expected` (cycles per pixel): only peaks within `tolerance` of it, as a
/// share; none: all. Nothing when no peak is left.
std::optional<FeedComb> feedComb(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                 std::optional<double> expected, double tolerance = 0.05);

/// Of the peaks within directionTolerance_deg of a direction the one with the best comb, those nearer to the direction
/// counting more: under chatter lines of the lattice are stronger, and lean. Nothing when there is none.
std::optional<FeedComb> feedCombAlong(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                      double direction_deg);
inline constexpr double directionTolerance_deg = 4;

/// Under strong chatter the feed's own line may be weaker than many others. Every pair of lines of the lattice differs,
/// or adds up, to a multiple of it: of all such distances next to `expected` the one on which the lines together stand
/// best (lattice_fit.h). `peaks`: the largest first. Nothing when no distance fits.
std::optional<FeedComb> feedUnderChatter(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                         double expected);

/// Two frequencies, or one and the opposite of the other, that a Hann window cannot tell apart.
bool coincide(const WindowedPicture& picture, Vector a, Vector b);

/// S of a line that supports others, though it would not be enough by itself.
inline constexpr double supportingSignificance = 7;

/// A feed line within this share of 1/f is looked for at first; a strong chatter line at 0.9/f is none.
inline constexpr double feedTolerance = 0.05;

/// Where a wave of `frequency` is seen when pixels sample it: within ±½ cycle per pixel.
Vector folded(Vector frequency);

}  // namespace lathelier::surface
