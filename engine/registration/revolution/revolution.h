// Registration of bodies of revolution: axis on axis, then one shift along it; the roll is not changed.
#pragma once

#include <vector>

#include "engine/registration/alignment.h"
#include "engine/registration/compare.h"
#include "engine/registration/revolution/revolution_axis.h"
#include "engine/registration/revolution/revolution_shoulders.h"

namespace lathelier::registration {

/// A body of revolution with its shoulders, in its axis frame.
struct TurnedPart {
    RevolutionFit fit;                ///< axis and radius along it
    std::vector<Shoulder> shoulders;  ///< in order of z in the axis frame
    std::vector<Shoulder> ends = {};  ///< end faces that the scan shows, the radius beyond them 0
};

/// The axis through the middle of the data, toward the larger coordinate on its dominant axis.
Axis axisOf(const RevolutionFit& fit);

/// Aligns the copy's axis with the reference's. Both directions are tried (only the nearer one, and shifts of up to a
/// tenth of the length, with InitialPose::Identity), and every shift at which the two profiles have much in common;
/// each is aligned, and the one with the least difference then is taken. The shift comes from shoulders, tapers and the
/// end faces that both scans show, not from where the data end; each is weighted by its inverse variance, and the
/// variance of tapers that contradict the shoulders (because their radii differ) is inflated. Free motions keep the
/// smallest rotation, and no shift from the initial pose where the two parts agree there. Error partsDoNotMatch when
/// the two profiles have nothing in common.
Alignment alignRevolution(const TurnedPart& reference, const TurnedPart& copy, InitialPose initial);

}  // namespace lathelier::registration
