// Chatter marks in the spectrum of a turned surface: a lattice of lines l·K_c + j·K_f about the comb of the feed marks.
// The surface is sampled once per feed, so that every line of the vibration has aliases at all distances j·K_f.
#pragma once

#include <optional>
#include <vector>

#include "engine/surface/feed_marks.h"

namespace lathelier::surface {

/// A detected line of the lattice.
struct LatticeLine {
    int multiple = 1;         ///< l: harmonic of the vibration
    int order = 0;            ///< j: order of the feed
    Vector frequency{};       ///< as measured, cycles per pixel
    double significance = 0;  ///< over the medians of rows and columns
    double amplitude = 0;     ///< in units of the flattened picture
};

struct ChatterLattice {
    Vector fundamental{};            ///< K_c, up to multiples of K_f and up to its sign, cycles per pixel
    double significance = 0;         ///< of the strongest line
    double amplitude = 0;            ///< of the strongest line
    std::vector<LatticeLine> lines;  ///< detected lines, the strongest first
    Vector feed{};                   ///< first line of the comb, fitted together with the lattice
};

/// Search parameters.
struct LatticeSearch {
    double threshold = 18;          ///< T: threshold of at least one line
    double least_amplitude = 0.02;  ///< smallest amplitude relative to the feed line
    /// Frequency of the original pixel grid in a rotated picture: interpolation leaves weak replicas of the comb at its
    /// multiples.
    std::optional<Vector> old_grid = {};
};

/// The lattice seeded by the strongest line outside the feed comb. This may be harmonic 1, 2 or 3 of the vibration: the
/// smallest fundamental with two lines of its own is used. Lines of light and those shorter than the feed
/// (line_origin.h) seed nothing. None if no line outside the comb exceeds the threshold.
/// `peaks` over the medians of rows and columns.
std::optional<ChatterLattice> chatterLattice(const WindowedPicture& picture, const Significance& significance,
                                             const FeedComb& feed, const std::vector<SpectralPeak>& peaks,
                                             const LatticeSearch& search);

}  // namespace lathelier::surface
