// From a lattice of lines in a picture to the frequency of the vibration: which readings are possible, how certain each
// is, and what decides among them.
// Source: chatter_geometry.h; uncertainty of a line's frequency 0.3 bin / √S, after D. C. Rife and R. R. Boorstyn,
// "Single tone parameter estimation", IEEE Trans. Inf. Theory 20 (1974), and not less than 5e-4 of a wave, which
// irregular tracks leave.
#pragma once

#include <optional>

#include "engine/surface/picture_lines.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// What the reading of a picture rests on besides its lines.
struct CutFacts {
    std::optional<double> feed_mm_rev;         ///< of the cut
    std::optional<double> diameter_mm;         ///< of the part
    std::optional<double> diameter_px;         ///< in pixels of the flattened picture
    std::optional<double> speed_rpm;           ///< of the spindle
    std::optional<double> feed_direction_deg;  ///< in the flattened picture
    CutDirection cut = CutDirection::Unknown;  ///< as asked
    std::optional<double> expect_hz;           ///< chooses among candidates
    double speed_uncertainty = 0.005;          ///< of the spindle speed, as a share
    bool unrolled = false;                     ///< the circumference was laid flat
    bool curved = false;                       ///< it curves away and was not laid flat: m is never certain
    bool scale_checked = true;                 ///< else it rests on which line was taken for the feed's: as curved
    int columns = 0;                           ///< of the flattened picture
    int rows = 0;                              ///< of the flattened picture
};

/// The comb's vector pointing in the direction of feed, or, where that is not known, to the right.
Vector towardFeed(Vector comb, const std::optional<double>& feed_direction_deg);

/// `path` for the notes directionsUnknown, wavesUncertain, chosenByExpectation.
ChatterMarks readChatter(const ChatterLattice& lattice, const FeedComb& feed, const CutFacts& facts,
                         const std::string& path, Notes& notes);

}  // namespace lathelier::surface
