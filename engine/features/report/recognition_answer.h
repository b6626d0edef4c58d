// A recognition as one sentence with its findings.
#pragma once

#include "engine/features/recognition.h"
#include "engine/report/answer.h"

namespace lathelier::features {

/// "Length 183.002 ± 0.010 mm": the same on the command line, in the panel and in the report. There is no verdict: a
/// scan has no limits. Ends that are not decided come first among the findings, with where they may lie.
report::Answer answer(const Recognition& result);

/// Two digits of the uncertainty, from hundredths of a millimetre to tenths of a micrometre.
int decimalsFor(double uncertainty);

}  // namespace lathelier::features
