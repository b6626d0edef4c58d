// The frequency response of a shaft, and an identified spindle, as reports and answers.
#pragma once

#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/report/document.h"

namespace lathelier::receptance {

report::Answer answer(const ShaftReceptanceResult& result, const Language& language = {});
report::Answer answer(const SpindleIdentification& result, const Language& language = {});

/// Plain text for the command line.
report::Section frfSummary(const ShaftReceptanceResult& result, const Language& language = {});
report::Section spindleSummary(const SpindleIdentification& result, const Language& language = {});

/// Natural frequencies, receptance, method and parameters.
report::Document frfReport(const ShaftReceptanceResult& result, const Language& language = {});
/// Quality of the identification, the receptances found, method and parameters.
report::Document spindleReport(const SpindleIdentification& result, const Language& language = {});

}  // namespace lathelier::receptance
