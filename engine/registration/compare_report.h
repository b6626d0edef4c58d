// The comparison of a copy with its original as a report, and as one sentence.
#pragma once

#include <vector>

#include "engine/registration/compare.h"
#include "engine/report/document.h"

namespace lathelier::registration {

/// "RMS 0.0557 mm · mean +0.0041 mm · body of revolution · 97.3 % within ±0.1 mm ✓": the same on the command line, in
/// the panel and in the report.
report::Answer answer(const CompareResult& result, const Language& language = {});

/// Answer, statistics, verdict and notes: the first section of the report, and what the command line prints.
report::Section compareSummary(const CompareResult& result, const Language& language = {});

/// Everything the result holds, the most wanted first: headline, statistics and verdict, notes; where (pictures,
/// unrolled map, deviation along the axis, meridian, zones); distribution; how sure; method and parameters.
report::Document compareReport(const CompareResult& result, const std::vector<InputFile>& inputs,
                               const Language& language = {}, std::vector<report::Picture> pictures = {});

}  // namespace lathelier::registration
