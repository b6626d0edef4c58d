// "Verify installation" as a report, as one sentence, and as a table that other reports quote.
#pragma once

#include "engine/report/document.h"
#include "engine/verify/verify.h"

namespace lathelier {

/// "All 12 kinds of reference data agree with their known answers ✓".
Headline headline(const VerifyResult& result, const Language& language = {});

/// Kind, sets, largest deviation, limit, verdict.
Table verifyTable(const VerifyResult& result);

Section verifySummary(const VerifyResult& result, const Language& language = {});
Document verifyReport(const VerifyResult& result, const Language& language = {});

/// Verifies what the document names as its verification, and adds it as the last section; once. Throws Cancelled.
void quoteVerification(Document& document, const Progress& progress = {}, const Language& language = {});

}  // namespace lathelier
