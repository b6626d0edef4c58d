// The path of a program for drawing and picking: straight pieces in the meridian plane, each with its block.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/gcode/move.h"
#include "engine/report/chart.h"
#include "engine/stock/convex_polygon.h"
#include "engine/stock/machine_limits.h"

namespace lathelier::stock {

/// A piece of the path by the number of its last corner.
using PathPiece = std::size_t;

/// Visible part of the plane and pixel size. Default: unbounded, all corners.
struct PathWindow {
    Interval z_mm{-endless_mm, endless_mm};  ///< shown
    Interval x_mm{-endless_mm, endless_mm};  ///< shown
    double pixel_z_mm = 0;                   ///< 0: every corner is drawn
    double pixel_x_mm = 0;                   ///< 0: every corner is drawn
};

class DrawnPath {
public:
    DrawnPath() = default;  ///< an empty path

    /// `blocks`: lines of the program. z = z_zero - Z; arcs become chords within 5 µm. 32 bytes a corner. Throws
    /// Cancelled.
    DrawnPath(std::span<const gcode::Move> moves, double z_zero_mm, std::size_t blocks, const Progress& progress = {});

    std::size_t corners() const { return corners_.size(); }
    const Corner& corner(std::size_t index) const { return corners_[index]; }
    bool isPiece(std::size_t index) const { return !isFirst_[index]; }  ///< false: first corner of a connected stretch
    bool isRapid(PathPiece piece) const { return isRapid_[piece]; }
    std::int64_t lineOf(PathPiece piece) const { return line_[piece]; }
    int toolOf(PathPiece piece) const { return tool_[piece]; }

    /// Pieces of a block in order of execution; empty if it does not move. Includes the first corner of a stretch for
    /// moves with unknown start.
    std::span<const std::uint32_t> piecesOf(std::int64_t line) const;

    /// The piece nearest to a place, distances measured in pixels; `none` when there is no piece. O(corners).
    PathPiece nearest(const Corner& place, double pixel_z_mm, double pixel_x_mm) const;
    static constexpr PathPiece none = static_cast<PathPiece>(-1);

    /// The whole path on `pixels` × `pixels`.
    PathWindow whole(int pixels) const;

    /// Feed moves and rapid moves as curves of a chart, without pieces outside of the window, corners nearer than half
    /// a pixel to the one before, and pieces that fall on one already drawn. O(corners).
    std::vector<report::Curve> curves(const PathWindow& window) const;

private:
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> line_;
    std::vector<int> tool_;
    std::vector<bool> isRapid_;
    std::vector<bool> isFirst_;
    std::vector<std::uint32_t> byLine_;  ///< pieces, grouped by line
    std::vector<std::uint32_t> begin_;   ///< of each line in byLine_; one more than lines
    Box extent_;
};

}  // namespace lathelier::stock
