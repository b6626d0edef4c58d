// Rows of a recognition and those of a drawing on one axis, in order of z, as row_matching.h takes them.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

#include "engine/features/comparison/row_matching.h"
#include "engine/features/recognition.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

using RowsOnAxis = std::vector<RowOnAxis>;

/// From the z of the recognition to that of the drawing.
struct Placing {
    bool turned = false;   ///< end for end
    double offset_mm = 0;  ///< added after that
    double at(double z_mm) const { return offset_mm + (turned ? -z_mm : z_mm); }
};

/// Candidate placings of the measured rows: as stated, and with either end on end, since the axial position may not be
/// determined. `nominal_T_part`: from the frame of the recognition to that of the drawing; none: either end first.
std::vector<Placing> placings(const Shaft& nominal, const Recognition& measured,
                              const std::optional<Eigen::Isometry3d>& nominal_T_part);

/// Are the ends of the part seen, the free one first?
std::array<bool, 2> endsSeen(const Recognition& measured);

/// `outer_seen`: whether the first and the last of all ends of the data are ends of the part. Where rows do not join
/// there are no data.
RowsOnAxis placed(const std::vector<RecognizedRow>& rows, const Placing& placing, std::array<bool, 2> outer_seen);

/// Rows of the bores: the deepest one of a blind bore ends where its data end.
RowsOnAxis placedBores(const Recognition& measured, const Placing& placing);

/// The rows of the drawing that have sizes. `sense` -1: from a mouth at the chuck's end.
RowsOnAxis drawnRows(const std::vector<ShaftSegment>& rows, double z_mm, double sense);
RowsOnAxis drawnRows(const std::vector<BoreSegment>& rows, double z_mm, double sense);

/// The bores of the drawing. Where the rows state them, steps of one diameter are one row.
std::vector<ShaftBore> drawnBores(const Shaft& nominal);

}  // namespace lathelier::features
