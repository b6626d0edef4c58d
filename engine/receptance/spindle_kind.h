// Files of spindles, and of the tap tests that identify them, as kinds of file.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::receptance {

/// SPINDLE.json. facts: format "spindle_json"; details "source" ("springs" | "table"); of springs "radial_N_mm",
/// "tilt_N_mm_rad", "loss_factor"; of a table "lines", "from_hz", "to_hz".
const io::FileKind& spindleFiles();

/// MEASUREMENTS.json. facts: format "measurements_json"; details "frf" (the file of responses), "rods" [{length_mm,
/// diameter_mm, material, points}].
const io::FileKind& measurementFiles();

}  // namespace lathelier::receptance
