// All periodic lines of one flattened picture: is anything periodic, the comb of the feed, the lattice of the chatter.
#pragma once

#include <optional>

#include "engine/core/progress.h"
#include "engine/surface/chatter_lattice.h"
#include "engine/surface/feed_marks.h"
#include "engine/surface/grid.h"

namespace lathelier::surface {

/// How much of a picture a family of lines is.
struct Weight {
    double regularity = 0;  ///< power within ±1.5 bins of its strongest line over that within ±20 % of its frequency
    double share = 0;       ///< of the power of the whole picture, all lines of the family
};

struct PictureLines {
    double threshold = 0;                   ///< T
    double largest_significance = 0;        ///< S of the strongest line over log-means
    std::optional<FeedComb> feed;           ///< none: nothing periodic
    Weight feed_weight;                     ///< of the comb
    std::optional<ChatterLattice> chatter;  ///< none: nothing beside the comb
    Weight chatter_weight;                  ///< of the lattice
    double least_chatter = 0;               ///< amplitude of a line that would just have been found
    PowerSpectrum spectrum;                 ///< to draw; not turned
};

/// What is known beforehand.
struct LineSearch {
    std::optional<double> feed_cycles_per_px;  ///< 1/f in pixels; none: the best comb is the feed
    double alpha = 1e-3;                       ///< chance of a false line
    double least_chatter = 0.02;               ///< amplitude relative to the feed line
    std::optional<Vector> old_grid = {};       ///< LatticeSearch::old_grid
    std::optional<double> direction_deg = {};  ///< of the feed, about; tells the comb where 1/f is not known
    bool feed_only = false;                    ///< no lattice, no weights: quicker
};

PictureLines findLines(const Grid& flat, const LineSearch& search, const Progress& progress = {});

}  // namespace lathelier::surface
