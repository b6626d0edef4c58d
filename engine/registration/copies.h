// Several copies compared with one original: a table row for each, and the trend over the copies.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/core/json.h"
#include "engine/registration/compare.h"
#include "engine/report/document.h"

namespace lathelier::registration {

/// What is kept of one copy's comparison.
struct CopySummary {
    std::string name;                ///< display name: that of its file
    std::optional<Verdict> verdict;  ///< none: nothing was judged
    std::optional<WorstPlace> worst;
    double mean_mm = std::numeric_limits<double>::quiet_NaN();     ///< of the signed deviations
    double rmse_mm = std::numeric_limits<double>::quiet_NaN();     ///< root mean square deviation
    double scatter_mm = std::numeric_limits<double>::quiet_NaN();  ///< noise of the scans
    std::optional<InputFile> file;                                 ///< that it was read from; none: not read
    std::optional<Error> error;                                    ///< why there are no numbers
};

CopySummary summaryOf(std::string name, const CompareResult& result);

/// One object for each copy: `name`, `verdict`, `worst`, `mean_mm`, `rmse_mm`, `scatter_mm`; of a failed comparison
/// `name` and `error`.
Json toJson(const std::vector<CopySummary>& copies);

/// One row for each copy, in the order of `copies`; a failed comparison gives its error.
report::Table copiesTable(const std::vector<CopySummary>& copies, const Language& language = {});

/// The worst local deviation with its expanded uncertainty, and the mean, over the number of the copy, with the
/// tolerance. Copies without numbers leave a gap.
report::Plot copiesTrend(const std::vector<CopySummary>& copies, const CompareParameters& parameters,
                         const Language& language = {});

}  // namespace lathelier::registration
