// The comparison of a copy with its original as a report, and as one sentence.
#pragma once

#include <vector>

#include "engine/registration/compare.h"
#include "engine/report/document.h"

namespace lathelier::registration {

/// "RMS 0.0557 mm · mean +0.0041 mm · body of revolution · worst +0.0503 ± 0.0010 mm at z = 103.0 mm · limit ±0.04 mm
/// ✗"; by rule points "… 97.3 % within ±0.1 mm ✓": the same on the command line, in the panel and in the report.
Headline headline(const CompareResult& result, const Language& language = {});

/// Headline, verdict with the worst place, what differs, statistics and notes: the first section of the report, and
/// what the command line prints.
Section compareSummary(const CompareResult& result, const Language& language = {});

/// Everything the result holds, the most wanted first: headline, verdict, what differs, statistics, notes; where
/// (pictures, unrolled map, deviation along the axis, meridian, zones); distribution; how sure; method and parameters.
Document compareReport(const CompareResult& result, const std::vector<InputFile>& inputs, const Language& language = {},
                       std::vector<Picture> pictures = {});

}  // namespace lathelier::registration
