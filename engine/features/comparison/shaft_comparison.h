// A scan against the drawing of a shaft: the signed deviation from its surface, and its sizes row by row.
#pragma once

#include <optional>
#include <vector>

#include "engine/features/comparison/nominal_rows.h"
#include "engine/registration/compare.h"
#include "engine/report/document.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

struct ShaftComparison {
    /// The reference is the shaft: its frame is z along the axis from the free end. `verdict` there is the surface's.
    registration::CompareResult surface;
    Shaft nominal;                   ///< the drawing
    std::vector<ComparedRow> rows;   ///< as compareRows() has them
    std::optional<Verdict> verdict;  ///< the worse of the surface and the rows; none: nothing has a limit
};

/// Aligns the copy with the shaft's mesh (shaft_mesh.h), measures its deviations from the shaft's meridian, recognises
/// it and sets its rows against the drawing's. Errors of compare(). A copy that cannot be recognised gives rows without
/// measured values and the note sizesNotRecognized. Notes: those of both. Precondition: the shaft passes checkShaft().
/// Throws Cancelled.
ShaftComparison compareWithShaft(const Shaft& nominal, const Scan& copy,
                                 const registration::CompareParameters& parameters, const Progress& progress = {},
                                 registration::CompareDetail detail = registration::CompareDetail::Full);

/// Where the size lies along the axis, as the surface's views count z.
Interval placeOf(const ShaftComparison& result, const ComparedRow& row);

/// Recomputes the verdict of the surface with the limits of `parameters` (registration::judge()) and the verdict of
/// both. Precondition: decision and scanner accuracy, which the rows were judged by, are the same as before.
void judgeSurface(ShaftComparison& result, const registration::CompareParameters& parameters,
                  const Progress& progress = {});

/// The answer of the comparison of two scans with the verdict of both, and the sizes that are not within as findings.
report::Answer answer(const ShaftComparison& result, const Language& language = {});

/// One line for each size: nominal, measured, difference, U, and where there are limits these and the verdict.
report::Table sizesTable(const ShaftComparison& result);

/// As the comparison of two scans, with `rows`, the verdict of both, and `surface_verdict`.
Json toJson(const ShaftComparison& result);

/// The verdict of surface and sizes, and the sizes as a table.
report::Section sizesSection(const ShaftComparison& result);

/// The summary of the comparison of two scans; its answer has the verdict of both, and the sizes that are not within.
report::Section surfaceSummary(const ShaftComparison& result, const Language& language = {});

/// The report of the comparison of two scans with the sizes behind its first section.
report::Document shaftReport(const ShaftComparison& result, const std::vector<InputFile>& inputs,
                             const Language& language = {}, std::vector<report::Picture> pictures = {});

}  // namespace lathelier::features
