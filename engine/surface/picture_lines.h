// All periodic lines of one flattened picture: test for periodicity, comb of the feed, lattice of the chatter.
#pragma once

#include <optional>

#include "engine/core/progress.h"
#include "engine/surface/chatter_lattice.h"
#include "engine/surface/feed_marks.h"
#include "engine/surface/grid.h"

namespace lathelier::surface {

/// Share of a family of lines in a picture.
struct Weight {
    double regularity = 0;  ///< power within ±1.5 bins of its strongest line over that within ±20 % of its frequency
    double share = 0;       ///< share of all lines of the family in the power of the picture
};

struct PictureLines {
    double threshold = 0;                   ///< T
    double largest_significance = 0;        ///< S of the strongest line relative to log-means
    std::optional<FeedComb> feed;           ///< none: nothing periodic
    Weight feed_weight;                     ///< of the comb
    std::optional<ChatterLattice> chatter;  ///< none: no line outside the comb
    Weight chatter_weight;                  ///< of the lattice
    std::optional<FeedComb> second_feed;    ///< the same lines as marks of another feed in a part of the picture
    double least_chatter = 0;               ///< detection limit of the amplitude
    PowerSpectrum spectrum;                 ///< for display; not rotated
};

/// Prior knowledge for the search.
struct LineSearch {
    std::optional<double> feed_cycles_per_px;  ///< 1/f in pixels; none: the best comb is the feed
    double alpha = 1e-3;                       ///< probability of a false detection
    double least_chatter = 0.02;               ///< smallest amplitude relative to the feed line
    std::optional<Vector> old_grid = {};       ///< LatticeSearch::old_grid
    std::optional<double> direction_deg =
        {};                  ///< approximate direction of the feed; selects the comb if 1/f is unknown
    bool feed_only = false;  ///< skips lattice and weights
};

PictureLines findLines(const Grid& flat, const LineSearch& search, const Progress& progress = {});

}  // namespace lathelier::surface
