// Roundness of profiles as a report, and as one sentence.
#pragma once

#include <array>
#include <vector>

#include "engine/form/roundness/roundness.h"
#include "engine/report/document.h"

namespace lathelier::form {

/// "RONt(MZCI) 5.3 µm · G 1-50 UPR · within 8 µm ✓": the same on the command line, in the panel and in the report. The
/// filter is part of the result's name.
report::Answer answer(const RoundnessResult& result, const Language& language = {});

/// Answer, deviations by the four circles, verdict and notes: what the command line prints.
report::Section roundnessSummary(const RoundnessResult& result, const Language& language = {});

/// The complete result: headline, deviations by the four circles, verdict, notes; polar plot with the circles and the
/// contact points of the chosen one; spectrum with causes; method table; sizes; uncertainty; method and parameters.
/// Several results begin with a table of all.
report::Document roundnessReport(const std::vector<RoundnessResult>& results, const std::vector<InputFile>& inputs,
                                 const Language& language = {});

/// Of the rows of circlesTable().
inline constexpr std::array circlesOfTable{ReferenceCircle::MZCI, ReferenceCircle::LSCI, ReferenceCircle::MICI,
                                           ReferenceCircle::MCCI};

/// Deviation, centre, radii and proof by each reference circle.
report::Table circlesTable(const RoundnessResult& result);

/// "no filter", "G 1-50 UPR", "G 15-500 UPR": the filter as part of a result's name.
std::string filterName(const signal::TransmissionBand& band, const Language& language = {});

/// Decimals that show the first two digits of an uncertainty, one to three; two where there is none.
int decimalsFor(double uncertainty_um);

}  // namespace lathelier::form
