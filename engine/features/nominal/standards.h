// Tables of standards that a turned part's sizes are compared with: with their sources.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lathelier::features {

enum class UndercutForm { E, F };

/// An undercut of DIN 509:2006, table 1. E: 15° run-out from the cylinder to the depth t1, a flat bottom, the radius r
/// into the face; F: the radius goes t2 beyond the face and comes back to it under 8°.
struct Undercut {
    double radius_mm;             ///< r, ±0.1
    double depth_mm;              ///< t1, +0.1 0
    double width_mm;              ///< f from the run-out's start to the face, +0.2 0
    double face_depth_mm;         ///< t2, +0.05 0
    double over_mm, to_mm;        ///< shaft diameters that it is meant for: ]over, to]
    bool for_alternating_stress;  ///< the series with increased fatigue strength
};
constexpr double undercutRunOut_deg = 15, undercutFace_deg = 8;
std::span<const Undercut> undercuts();

/// "DIN 509 - E 0.6×0.2".
std::string designationOf(const Undercut& undercut, UndercutForm form);
/// Radial extent of form F from its bottom to where its face ends: r(1 + sin 8°) + (t2 - r(1 - cos 8°))/tan 8°.
double faceExtent_mm(const Undercut& undercut);

/// A groove for a retaining ring of DIN 471:2011.
struct CirclipGroove {
    double shaft_mm;   ///< d1
    double groove_mm;  ///< d2
    double width_mm;   ///< m, H13
};
std::span<const CirclipGroove> circlipGrooves();

/// A parallel key of DIN 6885-1:1968 and its slot in the shaft.
struct ParallelKey {
    double over_mm, to_mm;  ///< shaft diameters that it is meant for: ]over, to]
    double width_mm;        ///< b
    double height_mm;       ///< h
    double slot_mm;         ///< t1, depth of the slot in the shaft
};
std::span<const ParallelKey> parallelKeys();
std::span<const double> keyLengths_mm();  ///< of DIN 6885-1

/// Nominal diameters and coarse pitches of ISO 261:1998.
struct CoarseThread {
    double diameter_mm, pitch_mm;
};
std::span<const CoarseThread> coarseThreads();
std::span<const double> finePitches_mm();  ///< ISO 261, those in use

std::span<const double> chamferLegs_mm();
std::span<const double> chamferAngles_deg();  ///< to the axis
std::span<const double> radii_mm();           ///< DIN 250

/// A standard taper: C = (D - d)/L.
struct StandardTaper {
    std::string_view name;  ///< "1:10", "Morse 4"
    double ratio;           ///< C
    double gauge_mm;        ///< diameter of the gauge plane (DIN 228-1, Morse only); 0: any size
};
std::span<const StandardTaper> standardTapers();  ///< ISO 1119 (DIN 254), ISO 7388 (7:24), DIN 228-1

/// Tolerance classes of ISO 2768-1:1989: f, m, c, v.
enum class GeneralClass { Fine, Medium, Coarse, VeryCoarse };
/// "ISO 2768-m", also with a class of part 2 behind it ("ISO 2768-mK"); none: no such class.
std::optional<GeneralClass> parseGeneralTolerance(std::string_view text);
/// General tolerances of ISO 2768-1:1989, table 1, ± about the size; none: below 0.5 mm (stated beside the size) or
/// beyond the table: over 2 m for f, over 4 m, up to 3 mm for v.
std::optional<double> generalTolerance_mm(double length_mm, GeneralClass general = GeneralClass::Medium);
/// The same of table 2, for broken edges: outer radii and heights of chamfers; none: below 0.5 mm.
std::optional<double> generalEdgeTolerance_mm(double size_mm, GeneralClass general = GeneralClass::Medium);
/// The same for angles, class m, by the shorter side.
double generalAngleTolerance_deg(double shorter_side_mm);

}  // namespace lathelier::features
