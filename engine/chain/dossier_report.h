// Answer and tables of a dossier: steps with their files, numbers with their positions. The report: dossier_cover.h.
#pragma once

#include <optional>

#include "engine/chain/dossier.h"
#include "engine/report/document.h"

namespace lathelier::chain {

report::Table stepsTable(const Dossier& dossier);
report::Table filesTable(const Dossier& dossier);    ///< inputs and outputs of each step with their digests
report::Table numbersTable(const Dossier& dossier);  ///< value, U, file and place

/// The verdict of the copy with its largest deviation and tolerance, and the last step done.
report::Answer answer(const Dossier& dossier);

/// The largest deviation of the copy, compared with its limit if given; none: no copy.
std::optional<report::Finding> copyFinding(const Dossier& dossier);

/// Displayed title of a step.
Text titleOf(const std::string& step);

}  // namespace lathelier::chain
