// Synthetic scans with known truth: a turned shaft under a rotary scanner, and a bracket that is no body of revolution.
// The shaft and the scanner are those of the source paper (Miądlicki et al., Table 1 and section 3): 0.9° × 0.1 mm.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/scan.h"

namespace lathelier::sample {

/// One piece of a shaft's meridian, from z_start to z_end (z from the free end), with errors of manufacture on radius.
/// Neighbours with different radii are joined by a shoulder; a chamfer or cone is a piece with two radii.
struct ShaftPiece {
    double z_start_mm = 0;                          ///< from the free end
    double z_end_mm = 0;                            ///< from the free end, beyond z_start
    double radius_start_mm = 0;                     ///< nominal, at z_start
    double radius_end_mm = 0;                       ///< nominal, at z_end
    double oversize_um = 0;                         ///< constant over the piece
    double taper_start_um = 0;                      ///< linear from the piece's start…
    double taper_end_um = 0;                        ///< …to its end
    double barrel_um = 0;                           ///< parabola: this much at mid length, 0 at the barrel's ends
    double barrel_start_mm = 0, barrel_end_mm = 0;  ///< where the parabola is 0; both 0: the piece's own ends
};

/// Pieces in order of z, without gaps.
using ShaftModel = std::vector<ShaftPiece>;

ShaftModel nominalShaft();  ///< R15 z 0-98, R18.5 z 98-108, R16.9 z 108-183 with a 5 mm chamfer at its end
ShaftModel copiedShaft();   ///< with the taper, the oversize collar and the barrel of the practice data

/// Radius with errors at z; the larger one at a shoulder; 0 outside.
double radius_mm(const ShaftModel& shaft, double z_mm);

/// How a scan is made. Rays run horizontally toward the scanner's axis (z), rows of constant z; noise is along the ray.
struct ScannerModel {
    double row_pitch_mm = 0.1;     ///< distance of the rows along z
    double angle_step_deg = 0.9;   ///< between neighbouring rays of a row
    double spot_mm = 0.15;         ///< the range is that of a random place within this height about the ray
    double sigma_mm = 0.05;        ///< standard deviation of the range
    double dropout_share = 0;      ///< half of them in patches, half single
    double spurious_share = 0;     ///< of the remaining points, added evenly in a box around the part
    double part_z_from_mm = -1e9;  ///< start of the scanned stretch, z from the free end
    double part_z_to_mm = 1e9;     ///< end of that stretch, z from the free end
    double scan_z_from_mm = -1e9;  ///< lowest scanned row in scanner coordinates
    double scan_z_to_mm = 1e9;     ///< highest scanned row
    Eigen::Isometry3d scan_T_part = Eigen::Isometry3d::Identity();   ///< pose of the part near the axis of the scanner
    Eigen::Isometry3d frame_T_scan = Eigen::Isometry3d::Identity();  ///< moves the finished cloud
    std::uint64_t seed = 1;                                          ///< of all random numbers
};

/// Ray-cast scan of the shaft; 732 000 points for the nominal shaft. The same bits for any number of threads.
Scan scanShaft(const ShaftModel& shaft, const ScannerModel& scanner, const Progress& progress = {});

/// Closed triangle mesh of the shaft in its own frame, `sides` around.
Scan shaftMesh(const ShaftModel& shaft, int sides = 400);

/// Closed triangle mesh of an angle bracket, 100 × 80 × 90 mm, 12 mm thick, with three different holes.
Scan bracketMesh();

/// `count` points of the bracket's surface with noise along the normal, moved by `frame_T_part`. Carries no normals.
Scan scanBracket(std::size_t count, double sigma_mm, const Eigen::Isometry3d& frame_T_part, std::uint64_t seed,
                 const Progress& progress = {});

}  // namespace lathelier::sample
