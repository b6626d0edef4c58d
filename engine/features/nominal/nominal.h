// Candidate nominal sizes of measured ones, with the probability that an arbitrary size lies as near to one
// (false-match probability).
//
// Diameters and lengths: grids g = 5 (from 10 mm), 1, 0.5, 0.1 mm; N the nearest multiple; window
// w = min(U + t, g/20) with t = IT10(N)/2 (diameters) or half the tolerance ISO 2768-m (lengths); a grid counts when
// U <= g/20; the coarsest grid with |x - N| <= w wins; chance = 2w/g. 8000 simulated diameters, U 2 µm: 78 % right,
// 2 % wrong, the others none; of arbitrary numbers 28 % find one. Therefore they are suggested, and applied only on
// request.
//
// Series (legs, radii, tapers): the nearest member within its window; chance = 2w over the spacing of the series there.
// U is an expanded uncertainty (k = 2) everywhere. No function throws; for numbers that are not finite the result is
// empty.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/features/nominal/iso286.h"
#include "engine/features/nominal/standards.h"
#include "engine/features/recognition.h"

namespace lathelier::features {

/// Quantity "diameter_mm", with the fits of the nominal size that contain measured ± U.
std::optional<Suggestion> suggestDiameter(double measured_mm, double U_mm, Surface surface = Surface::Outer);

/// Quantity "length_mm", or "z_mm" for a baseline dimension. None below 0.5 mm, where no general tolerance is.
std::optional<Suggestion> suggestLength(double measured_mm, double U_mm, std::string_view quantity = "length_mm");

/// Quantity "leg_mm", along the axis: in the series within U + 0.1 mm, the angle to the axis 45, 30, 60, 15 or 20°
/// within U + 1°. Designation "1×45°".
std::optional<Suggestion> suggestChamfer(double leg_mm, double U_mm, double angle_deg, double U_deg);
/// The angle of chamfers that is within U + 1° of this one (of either sign); none: no such.
std::optional<double> nominalChamferAngle_deg(double angle_deg, double U_deg);

/// Quantity "radius_mm", without sign: DIN 250 within max(U, 5 %); beyond 50 mm the grids of lengths. Designation "R1".
std::optional<Suggestion> suggestRadius(double radius_mm, double U_mm);

/// A cone as it was measured.
struct MeasuredCone {
    double half_angle_deg = 0;  ///< of either sign
    double U_deg = 0;
    double small_mm = 0, large_mm = 0;  ///< diameters of its ends
    double length_mm = 0;               ///< along the axis
};
/// Quantity "taper": measured_mm and nominal_mm are C = (D - d)/L in mm per mm, difference_um in µm per mm. Standard
/// tapers whose half angle is within U + 0.005° (AT8 of ISO 1947), nearest first, at most three: Morse 1, Morse 2 and
/// 1:20 differ by no more. Morse only where the ends are 0.7 to 1.04 times its gauge diameter. Steeper than 10°:
/// "30°", an angle of chamfers, to the axis, within U + half the angle's tolerance ISO 2768-m.
std::vector<Suggestion> suggestTapers(const MeasuredCone& cone);

/// Quantity "diameter_mm" of an external metric thread's crest: pitch of ISO 261 within 1 %, crest within 6g (ISO
/// 965-1: es = -(15 + 11P), Td = 180 P^(2/3) - 3.15/√P µm, P in mm) ± U. Designation "M16×2".
std::optional<Suggestion> suggestThread(double crest_mm, double U_mm, double pitch_mm);

/// A value and its uncertainty.
struct Measured {
    double value_mm = 0, U_mm = 0;
};

/// The groove of DIN 471 on a shaft of this diameter (from the lower limit of h11 to the upper one of n6, ± U) with
/// this bottom (h12 ± U) and width (+0.14 0 ± U).
std::optional<CirclipGroove> circlipGrooveOf(Measured shaft, Measured bottom, Measured width);
/// "DIN 471 - 20": the ring is named by its shaft.
std::string designationOf(const CirclipGroove& groove);

/// An undercut as it was measured.
struct MeasuredUndercut {
    UndercutForm form = UndercutForm::E;
    double shaft_mm = 0;
    Measured depth, width, radius;  ///< t1; f, from the run-out's start to the face; r
};
/// The undercut of DIN 509 whose sizes are within tolerance (t1 +0.1 0, f +0.2 0, r ±0.1) ± U, the nearest. The shaft's
/// diameter only decides between equally near ones: the standard recommends the assignment.
std::optional<Undercut> undercutOf(const MeasuredUndercut& measured);
/// By its designation "DIN 509 - E 0.6×0.2"; none: no such.
std::optional<std::pair<Undercut, UndercutForm>> undercutOf(std::string_view designation);

}  // namespace lathelier::features
