// SETUP.json: the described fields of TurningSetup as JSON, with line and column for whatever does not fit.
#pragma once

#include <string>

#include "engine/core/error.h"
#include "engine/core/shaft.h"
#include "engine/deflection/setup.h"
#include "engine/io/file_kind.h"

namespace lathelier::deflection {

/// Errors with line and column: malformed, keyMissing (material coefficients, tool and chuck have to be stated),
/// keyOutOfRange. Notes: unknownKey, springsBesideDiameter.
TurningSetup readSetup(const std::string& json, Notes& notes);

/// The text of a file that readSetup() reads to the same bits.
std::string setupText(const TurningSetup& setup);

/// A set-up with its stock and what was understood of its file.
struct SetupFile {
    TurningSetup setup;          ///< as read
    std::optional<Shaft> stock;  ///< of the file that it names; none where it names none
    io::FileFacts facts;         ///< as setupFiles() has them
    Notes notes;                 ///< of both readings, with their paths
};

/// Opens the stock too (receptance/shaft_file.h: the text format or SHAFT.json), beside the set-up's file. Errors of
/// both readers, with the path.
SetupFile loadSetup(const io::FileToRead& file);

/// SETUP.json. facts: format "setup_json"; details "stock", "tailstock" (true | false), "steady_rests" (count),
/// "follower_rest", "K_tc_N_mm2".
const io::FileKind& setupFiles();

}  // namespace lathelier::deflection
