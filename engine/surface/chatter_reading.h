// From a lattice of lines in a picture to the frequency of the vibration: possible readings, their uncertainty, and the
// choice among them. Source: chatter_geometry.h; uncertainty of a line's frequency 0.3 bin / √S, after D. C. Rife and
// R. R. Boorstyn,
// "Single tone parameter estimation", IEEE Trans. Inf. Theory 20 (1974), and at least 5e-4 of a wave due to irregular
// tracks.
#pragma once

#include <optional>

#include "engine/surface/picture_lines.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// Known data of the cut and the picture.
struct CutFacts {
    std::optional<double> feed_mm_rev;
    std::optional<double> diameter_mm;
    std::optional<double> diameter_px;  ///< in pixels of the flattened picture
    std::optional<double> speed_rpm;
    std::optional<double> feed_direction_deg;  ///< in the flattened picture
    CutDirection cut = CutDirection::Unknown;
    std::optional<double> expect_hz;    ///< expected frequency, for the choice among candidates
    std::optional<double> scale_error;  ///< relative, of the pitch of the marks against the feed; none: not checked
    double speed_uncertainty = 0.005;   ///< relative standard uncertainty of the spindle speed
    bool unrolled = false;              ///< the cylinder was unrolled
    bool curved = false;                ///< the visible curvature was not unrolled: m is never certain
    bool scale_checked = true;          ///< false: the scale depends on the assumed feed line, treated as curved
    int columns = 0;                    ///< of the flattened picture
    int rows = 0;                       ///< of the flattened picture
};

/// The comb's vector pointing in the direction of feed, or to the right if it is unknown.
Vector towardFeed(Vector comb, const std::optional<double>& feed_direction_deg);

/// `path` for the notes directionsUnknown, wavesUncertain, chosenByExpectation.
ChatterMarks readChatter(const ChatterLattice& lattice, const FeedComb& feed, const CutFacts& facts,
                         const std::string& path, Notes& notes);

}  // namespace lathelier::surface
