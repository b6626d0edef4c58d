// Roundness of profiles as a report, and as one sentence.
#pragma once

#include <vector>

#include "engine/form/cylindricity.h"
#include "engine/form/roundness.h"
#include "engine/form/superimpose.h"
#include "engine/report/document.h"

namespace lathelier {

/// "RONt(MZCI) 5.3 µm · G 1-50 UPR · within 8 µm ✓": the same on the command line, in the panel and in the report. The
/// filter is part of the result's name.
Headline headline(const RoundnessResult& result, const Language& language = {});
Headline headline(const CylindricityResult& result, const Language& language = {});

/// Headline, deviations by the four circles, verdict and notes: what the command line prints.
Section roundnessSummary(const RoundnessResult& result, const Language& language = {});
Section cylindricitySummary(const CylindricityResult& result, const Language& language = {});

/// Everything a result holds, the most wanted first: headline and verdict; polar plot with the four circles and their
/// contact points; deviations; spectrum; method table; sizes; how sure; method and parameters; notes.
Document roundnessReport(const std::vector<RoundnessResult>& results, const std::vector<InputFile>& inputs,
                         const Language& language = {});
Document cylindricityReport(const CylindricityResult& result, const std::vector<InputFile>& inputs,
                            const Language& language = {});

/// Blocks that other reports share.
PolarPlot roundnessPolarPlot(const RoundnessResult& result);
Plot spectrumPlot(const RoundnessResult& result);
Table methodTable(const RoundnessResult& result);

}  // namespace lathelier
