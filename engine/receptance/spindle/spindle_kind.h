// Files of spindles, and of the tap tests that identify them, as kinds of file.
#pragma once

#include "engine/io/file_kind.h"
#include "engine/receptance/eirc/spindle_measurements.h"
#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::receptance {

/// A spindle with the facts of its file.
struct SpindleFile {
    SpindleReceptance spindle;
    io::FileFacts facts;  ///< see spindleFiles()
    Notes notes;          ///< notes of the reader, with the path
};

/// Errors of readSpindle(), with the path. Note spindleTableNotPassive.
SpindleFile loadSpindle(const io::FileToRead& file);

/// Rods and responses of MEASUREMENTS.json and of the file of frequency responses that it names.
struct TapTests {
    SpindleMeasurements measurements;  ///< rods and responses combined
    io::FileFacts facts;               ///< see measurementFiles()
    Notes notes;                       ///< of both files
};

/// Errors of readMeasurements() with the path, readFrf(), measurementsOf().
TapTests loadTapTests(const io::FileToRead& file);

/// SPINDLE.json. facts: format "spindle_json"; details "source" ("springs" | "table"); of springs "radial_N_mm",
/// "tilt_N_mm_rad", "loss_factor"; of a table "lines", "from_hz", "to_hz".
const io::FileKind& spindleFiles();

/// MEASUREMENTS.json. facts: format "measurements_json"; details "frf" (the file of responses), "rods" [{length_mm,
/// diameter_mm, material, points}].
const io::FileKind& measurementFiles();

}  // namespace lathelier::receptance
