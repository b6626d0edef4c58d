// The dossier as a report: which step made what of what, the numbers with their places, what is assumed, who confirmed
// what.
#pragma once

#include "engine/chain/dossier.h"
#include "engine/report/document.h"

namespace lathelier::chain {

report::Table stepsTable(const Dossier& dossier);
report::Table filesTable(const Dossier& dossier);    ///< inputs and outputs of each step with their digests
report::Table numbersTable(const Dossier& dossier);  ///< value, U, file and place

/// The verdict of the copy; else how far the chain came.
report::Answer answer(const Dossier& dossier);

/// Answer, steps, what the steps' own reports say in `steps`, numbers, files.
report::Document dossierReport(const Dossier& dossier, std::vector<report::Section> steps);

}  // namespace lathelier::chain
