// Workpiece and tool path discretised on common nodes along z; prepared once, so that repeated simulations (sliders,
// maps, samples) only repeat the cutting.
//
// Nodes lie at both ends of the stock, at shoulders and ends of segments, at rests, at the ends of blocks within the
// stock, along arcs as their chords need them, and between those no further apart than the step; nodes along arcs and
// in between on the grid of the program's Z, so that a corrected program can have its corners there. Radii
// belong to the ends of the pieces between nodes: a shoulder is two radii at one node.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/deflection/setup.h"
#include "engine/deflection/tool_path.h"
#include "engine/shaft/shaft.h"

namespace lathelier::deflection {

inline constexpr double metricGrid_mm = 0.001;    ///< of a length in a program that counts millimetres
inline constexpr double samePlanPlace_mm = 1e-7;  ///< along z: places no further apart are one node

/// Contour of a run between two nodes.
struct CutPiece {
    double start_mm = 0;             ///< radius of the contour at the node before
    double end_mm = 0;               ///< at the node after
    double feed_mm_rev = 0;          ///< feed of its block
    double slope_rad = 0;            ///< of the contour; positive: radius grows toward the chuck
    std::int64_t line = 0;           ///< line of its block
    std::optional<ArcCentre> arc{};  ///< that it belongs to; none: straight
    friend bool operator==(const CutPiece&, const CutPiece&) = default;
};

/// A run on the nodes: piece i lies between nodes first + i and first + i + 1.
struct CutPlan {
    ToolRun::Kind kind = ToolRun::Kind::TowardChuck;
    std::size_t first = 0;         ///< node where it enters the length of the stock
    std::vector<CutPiece> pieces;  ///< Plunge: none
    std::vector<bool> block_ends;  ///< for the nodes from `first` on: true at block ends
    ToolRun run;                   ///< the run itself

    std::size_t last() const { return first + pieces.size(); }
};

struct WorkPlan {
    std::vector<double> z_mm;             ///< nodes, n + 1, ascending from 0
    std::vector<double> outer_start_mm;   ///< stock radius at the start of each piece, n
    std::vector<double> outer_end_mm;     ///< stock radius at the end of each piece
    std::vector<double> bore_mm;          ///< radius in the middle, 0: solid
    std::vector<std::size_t> rest_nodes;  ///< of TurningSetup::steady_rests, in their order
    std::vector<CutPlan> cuts;            ///< in order; runs outside the stock are omitted

    double length_mm() const { return z_mm.back(); }
    std::size_t pieces() const { return outer_start_mm.size(); }
};

/// Errors: those of beam::uniformSegments(); stockTooShort (`line`) for a run that cuts beyond the chuck face;
/// feedMissing (`line`); placeOutsideShaft for a rest; tooManySteps.
WorkPlan workPlan(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                  double z_grid_mm = metricGrid_mm);

}  // namespace lathelier::deflection
