// "Verify installation" as a report, as one sentence, and as a table that other reports quote.
#pragma once

#include "engine/form/verify.h"
#include "engine/report/document.h"

namespace lathelier::form {

/// "All 12 kinds of reference data agree with their known answers ✓".
Headline headline(const VerifyResult& result, const Language& language = {});

/// Kind, sets, largest deviation, limit, verdict.
Table verifyTable(const VerifyResult& result);

Section verifySummary(const VerifyResult& result, const Language& language = {});
Document verifyReport(const VerifyResult& result, const Language& language = {});

/// Adds it to another report as its last section; once.
void quoteVerification(Document& document, const VerifyResult& result, const Language& language = {});

}  // namespace lathelier::form
