// STEP files of turned parts as a kind of file.
#pragma once

#include "engine/cad/step_reader.h"
#include "engine/io/file_kind.h"

namespace lathelier::cad {

/// A STEP part with the facts and notes of its file.
struct StepFile {
    StepPart part;
    io::FileFacts facts;  ///< as stepFiles() has them
    Notes notes;          ///< of the reading, with the path
};

/// Errors of readStep(), with the path.
StepFile loadStep(const io::FileToRead& file);

/// facts: format "STEP"; details "name", "segments", "bores", "length_mm", "largest_diameter_mm", "volume_mm3",
/// "other_faces".
const io::FileKind& stepFiles();

}  // namespace lathelier::cad
