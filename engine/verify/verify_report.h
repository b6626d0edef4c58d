// "Verify installation" as a report, as one sentence, and as a table that other reports quote.
#pragma once

#include "engine/report/document.h"
#include "engine/verify/verify.h"

namespace lathelier::verify {

/// "All 12 kinds of reference data agree with their known answers ✓".
report::Answer answer(const VerifyResult& result);

/// Kind, sets, largest deviation, limit, verdict.
report::Table verifyTable(const VerifyResult& result);

report::Section verifySummary(const VerifyResult& result);
report::Document verifyReport(const VerifyResult& result);

/// Runs the verification named in the document and adds it, once, as the last section. Throws Cancelled.
void quoteVerification(report::Document& document, const Progress& progress = {});

}  // namespace lathelier::verify
