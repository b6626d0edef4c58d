// Reading of a dossier file, so that a later run can reuse unchanged steps.
#pragma once

#include <optional>
#include <string>

#include "engine/chain/dossier.h"

namespace lathelier::chain {

/// Steps (files, request, parameters, remarks), numbers, confirmations, verdict. Notes are in `past_notes`; a step that
/// failed has its sentence in `remarks` and no error. Errors malformed, keyMissing (line, column), keyOutOfRange (a
/// step of no known state), those of FileBytes. Throws Cancelled.
Dossier readDossier(const std::string& path, const Progress& progress = {});

/// The same from the text of the file.
Dossier dossierFrom(std::string text);

/// The dossier in the folder of a chain; none: missing or unreadable.
std::optional<Dossier> dossierIn(const std::string& folder, const Progress& progress = {});

}  // namespace lathelier::chain
