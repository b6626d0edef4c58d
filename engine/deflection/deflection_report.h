// Deflection as answer, tables and report: the setter's sheet.
#pragma once

#include "engine/deflection/corrected_program.h"
#include "engine/deflection/deflection_plots.h"
#include "engine/report/document.h"

namespace lathelier::deflection {

/// Optional parts of the sheet.
struct ReportParts {
    const CorrectedProgram* corrected = nullptr;
    const ErrorBand* band = nullptr;
    const std::vector<Sensitivity>* sensitivities = nullptr;
    const DeflectionMap* map = nullptr;
    const IdentificationResult* identified = nullptr;
    std::optional<double> tolerance_um;  ///< of the diameter error, to both sides
};

/// Largest error against the tolerance; mean, range, and the offset that minimises the error.
report::Answer answer(const DeflectionResult& result, const std::optional<double>& tolerance_um = {},
                      const Language& language = {});
/// What the correction leaves with the uncertainty of the prediction, against the limit of the diameter error; within
/// only where the whole interval is. U: that of the band, else how far the error grows on the other machines of the
/// robustness; where neither was computed nothing is decided. Findings: whether the program reaches the prediction
/// (parameter tolerance_um), blocks.
report::Answer answer(const CompensationResult& result, const std::optional<double>& limit_um, const ErrorBand* band,
                      const Language& language = {});

report::Section deflectionSummary(const DeflectionResult& result, const std::optional<double>& tolerance_um = {},
                                  const Language& language = {});
/// Every changed word of the corrected program with its reason, and the robustness of the correction.
report::Section compensationSection(const CorrectedProgram& corrected, const std::optional<double>& limit_um,
                                    const ErrorBand* band, const Language& language = {});
report::Section identificationSection(const IdentificationResult& result);

report::Document deflectionReport(const DeflectionResult& result, const ReportParts& parts = {},
                                  const Language& language = {});

}  // namespace lathelier::deflection
