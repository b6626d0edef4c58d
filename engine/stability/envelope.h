// Lobes as curves over the spindle speed, and the lower envelope of many.
#pragma once

#include <utility>
#include <vector>

#include "engine/stability/lobes.h"

namespace lathelier::stability {

/// A point of a lobe.
struct CurvePoint {
    double speed_rpm = 0;
    double depth_N_mm = 0;    ///< K_r a: the depth in N/mm
    double frequency_hz = 0;  ///< of the chatter
};

/// One lobe, in unbroken stretches.
struct LobeCurve {
    int k = 0;                                       ///< whole waves between two revolutions
    std::vector<std::vector<CurvePoint>> stretches;  ///< each of at least one point
};

/// Range of lobe numbers of a stretch that may reach the speeds; empty if last < first.
struct LobeRange {
    int first = 0;
    int last = -1;
};
LobeRange lobesWithin(const std::vector<BoundaryPoint>& stretch, SpeedRelation relation, const Interval& speed_rpm);
LobeRange lobesWithin(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm);

/// Lobe k without process damping.
LobeCurve lobeCurve(const Boundary& boundary, int k, SpeedRelation relation);

/// The part of it that may reach the speeds, with one additional point at either end.
LobeCurve lobeCurve(const Boundary& boundary, int k, SpeedRelation relation, const Interval& speed_rpm);

/// Minimum of curves at evenly spaced speeds, as envelope(); of curves that are added one after another.
class LowerEnvelope {
public:
    LowerEnvelope(const Interval& speed_rpm, int points);

    void add(const LobeCurve& curve);
    LobeLimit take() { return std::move(limit_); }

private:
    void add(const CurvePoint& a, const CurvePoint& b, int k);

    double from_, to_, step_, last_;
    LobeLimit limit_;
};

/// Linear interpolation between the speeds of the limit; NaN outside, and if a neighbour is NaN.
double depthAt(const LobeLimit& limit, double speed_rpm);

}  // namespace lathelier::stability
