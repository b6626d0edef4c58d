// The comparison of a copy with its original as a report, and as one sentence.
#pragma once

#include <vector>

#include "engine/registration/compare.h"
#include "engine/report/document.h"

namespace lathelier::registration {

/// By the rule surface the worst place with its uncertainty against the limit and the largest finding; else the
/// RMS deviation: the same on the command line, in the panel and in the report.
report::Answer answer(const CompareResult& result, const Language& language = {});

/// Answer, verdict with the worst place, findings, statistics and notes: the first section of the report, and what
/// the command line prints.
report::Section compareSummary(const CompareResult& result, const Language& language = {});

/// One row for each zone, with name, limits and verdict where there are any.
report::Table zonesTable(const CompareResult& result);

/// The complete result, the most important first: answer, verdict, findings, statistics, notes; location (pictures,
/// unrolled map, deviation along the axis, meridian, zones); distribution; uncertainty; method and parameters.
report::Document compareReport(const CompareResult& result, const std::vector<InputFile>& inputs,
                               const Language& language = {}, std::vector<report::Picture> pictures = {});

}  // namespace lathelier::registration
