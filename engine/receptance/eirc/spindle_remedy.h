// The mistake of a tap test, by trying its remedies: a sign turned, two points of a rod swapped, a distance or a length
// stated wrongly.
//
// One wrong response spoils the least-squares fit of all, so that residuals alone do not tell the culprit. Each remedy
// is tried on a few lines: the right one brings chi² per degree of freedom from what it is to that of the others. It is
// named where it takes away nearly all of the excess and no other remedy does; nothing is applied.
#pragma once

#include <optional>

#include "engine/receptance/eirc/fit_spindle.h"

namespace lathelier::receptance {

enum class RemedyKind {
    Sign,      ///< of one response
    Swap,      ///< of two points of a rod
    Distance,  ///< of a point from the chuck
    Length,    ///< of a rod outside the chuck
    LeaveOut   ///< one response that none of the others mends
};

struct SpindleRemedy {
    RemedyKind kind = RemedyKind::Sign;
    std::size_t frf = 0;      ///< of Sign and LeaveOut: index in SpindleMeasurements::frfs
    std::size_t rod = 0;      ///< index of the rod
    std::size_t point_a = 0;  ///< of Swap and Distance: index of the point
    std::size_t point_b = 0;  ///< of Swap: the other one
    double stated_mm = 0;     ///< of Distance and Length
    double fitted_mm = 0;     ///< likewise; a point stays on its rod
};

/// The measurements as they would be with the remedy.
SpindleMeasurements remedied(const SpindleMeasurements& measurements, const SpindleRemedy& remedy);

/// None where the noise explains the residual, and where no single remedy does away with it. Precondition: `fits` and
/// `lines` are of `measurements` (without a held-out rod). Throws Cancelled.
std::optional<SpindleRemedy> findRemedy(const SpindleMeasurements& measurements, const SpindleNoise& noise,
                                        beam::ShearModel shear, const FitQuality& quality,
                                        const Progress& progress = {});

const char* key(RemedyKind kind);  ///< "sign" | "swap" | "distance" | "length" | "leave_out"

}  // namespace lathelier::receptance
