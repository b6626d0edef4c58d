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
/// share; none: all. None if no peak is left.
std::optional<FeedComb> feedComb(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                 std::optional<double> expected, double tolerance = 0.05);

/// Of the peaks within directionTolerance_deg of a direction the one with the best comb, weighted by their angular
/// distance, as under chatter the lattice lines are stronger and inclined. None if there is no peak.
std::optional<FeedComb> feedCombAlong(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                      double direction_deg);
inline constexpr double directionTolerance_deg = 4;

/// Under strong chatter the feed line may be weaker than many others. Differences or sums of lattice lines are
/// multiples of it: of all such differences near `expected`, the one with the best common fit of all lines is used
/// (lattice_fit.h). `peaks`: the largest first. None if no difference fits.
std::optional<FeedComb> feedUnderChatter(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                         double expected);

/// True if two frequencies, or one and the negative of the other, are unresolved under a Hann window.
bool coincide(const WindowedPicture& picture, Vector a, Vector b);

/// S required of an additional line of a comb or lattice.
inline constexpr double supportingSignificance = 7;

/// Relative tolerance of 1/f in the first search of the feed line; excludes strong chatter lines at 0.9/f.
inline constexpr double feedTolerance = 0.05;

/// Alias of a frequency under pixel sampling, within ±½ cycle per pixel.
Vector folded(Vector frequency);

}  // namespace lathelier::surface
