// Canned cycles of turning as moves. Everything in mm and radii; points are absolute.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/gcode/arc.h"
#include "engine/gcode/move.h"

namespace lathelier::gcode {

/// A move of a cycle; speed, tool and, unless it states one, feed are those of the modal state.
struct CycleMove {
    MoveKind kind = MoveKind::Rapid;
    Point to;
    Point centre;              ///< of an arc
    bool clockwise = false;    ///< of an arc
    double dwell_s = 0;        ///< of a dwell
    double feed = notANumber;  ///< of its own, in mm, per revolution or minute as the modal one
    std::int64_t line = 0;     ///< 0: that of the cycle
};
using CycleMoves = std::vector<CycleMove>;

/// G90: infeed along X, cut to `end`, out along X, back along Z. `taper_mm`: X at the start of the cut less that at its
/// end.
CycleMoves turningCycle(const Point& start, const Point& end, double taper_mm);
/// G94: infeed along Z (`taper_mm` in Z), cut to `end`, out along Z, back along X.
CycleMoves facingCycle(const Point& start, const Point& end, double taper_mm);
/// G92: as G90 with a thread.
CycleMoves threadCycle(const Point& start, const Point& end, double taper_mm);

/// G76 of Fanuc: pass n at depth first·√n, with steps of at least `least`; then height - finish, then `last_passes`
/// times the full height. No infeed along the flank: every pass starts and ends at the programmed Z.
struct MultiThread {
    Point end;  ///< root of the thread at its end
    double height_mm = 0;
    double first_mm = 0;     ///< depth of the first pass
    double least_mm = 0;     ///< of a step
    double finish_mm = 0;    ///< finishing allowance of the last pass
    double taper_mm = 0;     ///< X at the start less that at the end
    double run_out_mm = 0;   ///< length of the run-out at 45°; 0: none
    int last_passes = 1;     ///< at full height
    bool has_finish = true;  ///< two-block form: a pass at height - finish precedes the last
};
CycleMoves multiThread(const Point& start, const MultiThread& thread);
/// Passes of multiThread(); most + 1 where they are more.
std::int64_t roughPasses(const MultiThread& thread, std::int64_t most);

/// G76 of LinuxCNC: pass n at depth |peak| + first·n^(1/degression) from the drive line, full depth, spring passes. The
/// tool ends at the end of the drive line.
struct DriveThread {
    double end_z_mm = 0;         ///< of the drive line
    double peak_mm = 0;          ///< I: from the drive line to the peak; negative: external
    double first_mm = 0;         ///< J: first cut beyond the peak
    double height_mm = 0;        ///< K: full depth beyond the peak
    double degression = 1;       ///< R
    double compound_rad = 0;     ///< Q: angle of the infeed
    int springs = 0;             ///< H: spring passes at full depth
    double taper_length_mm = 0;  ///< E, along the drive line
    int tapers = 0;              ///< L: 1 entry, 2 exit, 3 both
};
CycleMoves driveThread(const Point& start, const DriveThread& thread);

/// G81…G89: along Z. Rapid to the R level, feed to the bottom (in pecks), dwell, out.
struct Drilling {
    double level_z_mm = 0;    ///< R
    double bottom_z_mm = 0;   ///< Z
    double peck_mm = 0;       ///< Q; 0: in one go
    double dwell_s = 0;       ///< at the bottom
    bool chip_break = false;  ///< retracts by peckClearance instead of to the R level (G73 of LinuxCNC)
    bool is_tap = false;      ///< a thread in and out (G84)
    bool feeds_out = false;   ///< G85, G86, G89
    bool to_level = false;    ///< ends at the R level (G99 of LinuxCNC); false: at the start
};
CycleMoves drilling(const Point& start, const Drilling& hole);

/// G74 (pecks along Z, steps along X) and G75 (`along_x`: pecks along X, steps along Z).
struct Pecking {
    Point end;              ///< opposite corner
    bool along_x = false;   ///< G75
    double peck_mm = 0;     ///< 0: in one go
    double step_mm = 0;     ///< 0: one groove
    double retreat_mm = 0;  ///< between pecks
    double relief_mm = 0;   ///< sideways at the bottom
};
CycleMoves pecking(const Point& start, const Pecking& groove);

/// A contour piece and the block that programs it.
struct ContourPiece {
    Piece piece;
    bool is_rapid = false;
    std::int64_t line = 0;
};

/// G71 (depth along X) and G72 (`is_face`: depth along Z): passes of `depth_mm` down to the contour shifted by the
/// allowance, each ending with a retreat of `retreat_mm` at 45° (along the feed axis and the depth axis) and a return
/// through the cut just made; then once along the shifted contour, and back to the start. Pockets are cut along their
/// falling flank.
struct Roughing {
    bool is_face = false;
    double depth_mm = 1;
    double retreat_mm = 0.5;
    double allowance_x_mm = 0;  ///< U/2, signed as programmed
    double allowance_z_mm = 0;  ///< W
};
CycleMoves roughing(const Point& start, const std::vector<ContourPiece>& contour, const Roughing& rough);
/// The radius that the contour of G71 reaches beyond the start before its last piece, so that the way back to the start
/// leads through it; none: it does not.
std::optional<double> reachesBeyond(const Point& start, const std::vector<ContourPiece>& contour,
                                    const Roughing& rough);

/// G73: the contour `passes` times, shifted by relief·(1 - j/(passes - 1)) + allowance.
struct Pattern {
    double relief_x_mm = 0;
    double relief_z_mm = 0;
    double allowance_x_mm = 0;
    double allowance_z_mm = 0;
    int passes = 1;
};
CycleMoves pattern(const Point& start, const std::vector<ContourPiece>& contour, const Pattern& pattern);

/// Cycles are truncated at this number of moves; the caller reports it.
inline constexpr std::size_t mostCycleMoves = 1000000;

}  // namespace lathelier::gcode
