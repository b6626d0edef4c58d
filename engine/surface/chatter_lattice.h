// Chatter marks in the spectrum of a turned surface: a lattice of lines l·K_c + j·K_f about the comb of the feed marks.
// The surface is sampled once per feed, so that every line of the vibration appears at all distances j·K_f.
#pragma once

#include <optional>
#include <vector>

#include "engine/surface/feed_marks.h"

namespace lathelier::surface {

/// One line of the lattice that is seen.
struct LatticeLine {
    int multiple = 1;         ///< l: of the vibration's frequency
    int order = 0;            ///< j: of the feed's
    Vector frequency{};       ///< as measured, cycles per pixel
    double significance = 0;  ///< over the medians of rows and columns
    double amplitude = 0;     ///< in units of the flattened picture
};

struct ChatterLattice {
    Vector fundamental{};            ///< K_c, up to multiples of K_f and up to its sign, cycles per pixel
    double significance = 0;         ///< of the strongest line
    double amplitude = 0;            ///< of the strongest line
    std::vector<LatticeLine> lines;  ///< that are seen, the strongest first
    Vector feed{};                   ///< the comb's first line, fitted together with the lattice
};

/// What is looked for.
struct LatticeSearch {
    double threshold = 18;          ///< T: one line must exceed it
    double least_amplitude = 0.02;  ///< of the feed line's amplitude
    /// The old grid of pixels as a frequency of a picture that was turned: interpolation leaves faint images of the
    /// comb at multiples of it.
    std::optional<Vector> old_grid = {};
};

/// The lattice that the strongest line beside the feed comb seeds. It may be line 1, 2 or 3 of the vibration: the
/// smallest fundamental is taken whose own lattice shows two lines. Nothing when no line beside the comb exceeds the
/// threshold. `peaks` over the medians of rows and columns.
std::optional<ChatterLattice> chatterLattice(const WindowedPicture& picture, const Significance& significance,
                                             const FeedComb& feed, const std::vector<SpectralPeak>& peaks,
                                             const LatticeSearch& search);

}  // namespace lathelier::surface
