// The sizes of a recognised part against those of its drawing: row by row measured - nominal, U, limits, verdict.
//
// Rows are matched in their order, by the z of their ends and their diameters; several measured rows, into which wear
// divides a cylinder, may correspond to one of the drawing. Limits: the class (ISO 286-1) or the deviations of the row
// for its diameters, else the general tolerance (ISO 2768-1: table 1 for sizes, table 2 for broken edges: legs of
// chamfers and outer radii); rows of undercuts, which have standards of their own, are left out of it. Sizes that the
// scan does not show (a length that ends with the data, an arc that is partly hidden) are not measured. Decision:
// core/conformity.h; of a diameter every local size must be within (ISO 14405-1).
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/quantities.h"
#include "engine/features/recognition.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

struct ComparedRow {
    std::int64_t row = 0;              ///< of the drawing, from 1; of a bore from its mouth inward
    std::optional<std::int64_t> bore;  ///< number of the bore, from 1; none: the outside
    /// "diameter" of a cylinder, "start_diameter" and "end_diameter" of a cone, "length", "arc_radius"
    std::string quantity;
    double nominal_mm = 0;                 ///< as drawn; a radius without its sign
    std::optional<double> measured_mm;     ///< of a cylinder the mean along it; none: not found on the part
    std::optional<double> smallest_mm;     ///< of a cylinder, at the ends of its measured part
    std::optional<double> largest_mm;      ///< largest of the same
    std::optional<double> deviation_mm;    ///< measured - nominal
    std::optional<double> uncertainty_mm;  ///< k = 2; none: not known
    std::optional<double> lower_mm;        ///< limit deviations from the nominal size; none: no such limit
    std::optional<double> upper_mm;
    std::optional<Verdict> verdict;  ///< none: no limit; undecided where a size with a limit was not found
};

/// The quantities of all rows of `nominal`, in their order, then those of its bores (of bores that the rows state,
/// neighbours of one diameter are one row). Planes (length 0) and rows that
/// run back have none. `nominal_T_part`: from the frame of the recognition (Recognition::part_T_scan) to that of the
/// drawing; none: either end first, laid end on end, whichever fits.
std::vector<ComparedRow> compareRows(const Shaft& nominal, const Recognition& measured, DecisionRule decision,
                                     const std::optional<Eigen::Isometry3d>& nominal_T_part = {});

/// The worst verdict of the rows; none: nothing has a limit.
std::optional<Verdict> worstVerdict(const std::vector<ComparedRow>& rows);

/// The quantity for people: "diameter at the start".
Text quantityName(const ComparedRow& row);

const std::vector<QuantityOf<ComparedRow>>& quantitiesOf(const ComparedRow*);

}  // namespace lathelier::features
