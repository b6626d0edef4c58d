// The dossier as a report: which step made what of what, the numbers with their places, what is assumed, who confirmed
// what.
#pragma once

#include <optional>

#include "engine/chain/dossier.h"
#include "engine/report/document.h"

namespace lathelier::chain {

report::Table stepsTable(const Dossier& dossier);
report::Table filesTable(const Dossier& dossier);    ///< inputs and outputs of each step with their digests
report::Table numbersTable(const Dossier& dossier);  ///< value, U, file and place

/// The verdict of the copy with its worst deviation against the tolerance, and how far the chain came.
report::Answer answer(const Dossier& dossier);

/// The worst deviation of the copy, judged against its limit where one is given; nullopt: there is no copy.
std::optional<report::Finding> copyFinding(const Dossier& dossier);

/// What people read of a step of this id.
Text titleOf(const std::string& step);

/// Answer, steps, what the steps' own reports say, numbers, files. Of a step that was taken over from an earlier run
/// its remarks stand in place of its report.
report::Document dossierReport(const Dossier& dossier);

}  // namespace lathelier::chain
