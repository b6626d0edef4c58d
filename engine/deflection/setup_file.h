// SETUP.json: the described fields of TurningSetup as JSON, errors with line and column; set-ups as inputs of tasks.
#pragma once

#include <string>

#include "engine/core/error.h"
#include "engine/deflection/setup_item.h"
#include "engine/io/file_kind.h"
#include "engine/shaft/shaft.h"

namespace lathelier::deflection {

/// Errors with line and column: malformed, keyMissing (material coefficients, tool and chuck have to be stated),
/// keyOutOfRange. Notes: unknownKey, springsBesideDiameter.
TurningSetup readSetup(const std::string& json, Notes& notes);

/// Notes of a set-up that is no file. Notes: springsBesideDiameter.
void noteSprings(const TurningSetup& setup, Notes& notes);

/// The text of a file that readSetup() reads to the same bits.
std::string setupText(const TurningSetup& setup);

/// A set-up with its stock, from the file named in it, and the facts of its file.
struct SetupFile : HeldSetup {
    io::FileFacts facts;  ///< as setupFiles() has them
    Notes notes;          ///< of both readings, with their paths
};

/// Also reads the stock file (io/shaft_file.h: text format or SHAFT.json), relative to the file of the set-up. Errors
/// of both readers, with the path.
SetupFile loadSetup(const io::FileToRead& file);

/// SETUP.json. facts: format "setup_json"; details "stock", "tailstock" (true | false), "steady_rests" (count),
/// "follower_rest", "K_tc_N_mm2".
const io::FileKind& setupFiles();

/// A set-up as an input of a task (task/inputs.h).
struct SetupInput {
    using File = SetupFile;
    using Value = HeldSetup;
    static constexpr const char* item = setupItem;

    static File read(const io::FileToRead& file) { return loadSetup(file); }
    static Value valueOf(const File& file) { return file; }
    static io::FileKinds kinds() { return {&setupFiles()}; }
    static std::optional<Value> ofItem(const Values& values) { return setupOf(values); }
};

}  // namespace lathelier::deflection
