// The limit by speeds instead of by lobes: at slow speeds many thousands of lobes reach a range, and at each speed only
// frequencies matter whose waves between two revolutions are whole.
#pragma once

#include <vector>

#include "engine/stability/boundary.h"
#include "engine/stability/lobes.h"

namespace lathelier::stability {

/// The least depth at one speed.
struct SpeedLimit {
    double depth_N_mm;                 ///< K_r a; infinite where no lobe limits
    double frequency_hz = notANumber;  ///< of the chatter
    int k = -1;                        ///< of the lobe
};

/// The limit at any speed. Between two points of the boundary depth and frequency are linear in the waves.
class LimitsBySpeed {
public:
    LimitsBySpeed(const Boundary& boundary, SpeedRelation relation);

    SpeedLimit at(double speed_rpm) const;

private:
    /// Two neighbouring points of the boundary.
    struct Piece {
        double least_N_mm;     ///< lesser depth of the two
        double depth_N_mm[2];  ///< K_r a
        double frequency_hz[2];
        double turns[2];
    };

    std::vector<Piece> pieces_;  ///< by ascending least depth: the search ends where no other can be less
    double first_;               ///< number of the first lobe
};

/// As envelope(), to the interpolation between points of the boundary. Throws Cancelled.
LobeLimit envelopeBySpeed(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm, int points,
                          const Progress& progress);

/// Of the lobes from `first` to `last` at most `most`, ascending: those with their foot, at the point of the largest
/// compliance, within the speeds, the fastest first; then the nearest to them.
std::vector<int> strongestLobes(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm, int first,
                                int last, std::size_t most);

}  // namespace lathelier::stability
