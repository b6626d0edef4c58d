// Inputs of the task compare: the reference, a scan or a drawing, and the copies.
#pragma once

#include <memory>
#include <string>

#include "engine/cad/task/compare_question.h"
#include "engine/cad/task/taken_part.h"
#include "engine/io/cloud/scan_input.h"
#include "engine/task/task.h"

namespace lathelier::cad {

inline constexpr const char* referenceRole = "reference";
inline constexpr const char* copyRole = "copy";
inline constexpr const char* copiesRole = "copies";  ///< further copies, of a window
inline constexpr const char* zonesRole = "zones";    ///< of the command line: a window edits the table

using LoadedScan = Loaded<io::ScanFile>;

/// What a copy is compared with: one of the two.
struct ReferenceTaken {
    std::shared_ptr<const LoadedScan> scan;  ///< null: a drawing
    std::shared_ptr<const PartTaken> drawn;  ///< passes checkShaft(); null: a scan
    std::string key;                         ///< changes with the content and with how it is read
};

/// The state with the units of the question in the reading options of reference and copies.
project::PanelState withUnits(project::PanelState state, const CompareQuestion& question);

/// The state as the command line states it: one unit, or one of the reference and one of the copy where they differ.
project::PanelState withStatedUnits(project::PanelState state);

/// Is the reference a drawing: an item, or by its head a STEP file or a SHAFT.json? A pipe has no head: no.
bool isDrawn(const project::Source& source);

/// Errors: those of ScanInput and PartInput, itemNotThere, those of checkShaft(), with the path.
ReferenceTaken takeReference(const project::PanelState& state, Stores& stores, task::Sources& sources,
                             const Progress& progress);

/// An error of the comparison names the role of a scan: adds what that input is called. Where the parts differ by the
/// ratio of two units, this becomes a note.
void explain(Error& error, const project::PanelState& state, const ReferenceTaken& reference, const Scan& copy,
             Notes& notes);

/// The inputs of the task.
std::vector<task::Input> compareInputs();

}  // namespace lathelier::cad
