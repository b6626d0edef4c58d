// Which program each clamping has: the planned one, one that came back corrected or from a file, or one that was
// changed by hand; and whether the checked text is the present one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cam/plan_programs.h"
#include "engine/gcode/program_item.h"
#include "engine/project/project.h"
#include "widgets/core/files/stores.h"
#include "widgets/turning/turning_question.h"

namespace lathelier::turning_panel {

struct TurningOutcome;

enum class ProgramOrigin : std::uint8_t {
    Planned,    ///< as planned
    Corrected,  ///< an item: corrected for deflection
    File        ///< of a file
};

/// The program of one clamping.
struct ShownProgram {
    ProgramOrigin origin = ProgramOrigin::Planned;  ///< origin of the text before edits
    std::string name;                               ///< of file or item; empty: planned
    std::string base;                               ///< text before edits
    std::string base_sha256;                        ///< digest of `base`
    std::string sha256;                             ///< digest of the present text
    bool is_changed = false;                        ///< edited by hand
    bool is_void = false;                           ///< changed since it was checked
};

/// Programs used in place of the planned ones; fills in `programs`, inputs and notes of the picture. Errors: those of
/// the readers; itemNotThere.
std::vector<cam::GivenProgram> chooseProgram(TurningOutcome& outcome, const cam::TurningPlan& planned,
                                             const project::PanelState& state, Stores& stores,
                                             const Progress& progress);

/// A program with the bar that it is planned for, for other panels. Without the bar in a second clamping, where the
/// stock is what the first one leaves.
gcode::ProgramItem itemOf(const TurningOutcome& outcome, std::size_t setup);

/// Its name in the project; empty: the part has none.
std::string nameOf(const TurningOutcome& outcome);

/// Whether this program is checked without findings and all its tools are known, so that it may be handed on and
/// written.
bool isSound(const TurningOutcome& outcome, std::size_t setup);

/// The state of the question with the program of this clamping changed by hand; none: as it was.
void setDraft(project::PanelState& state, const TurningOutcome& outcome, std::size_t setup,
              const std::optional<std::string>& utf8);

/// Marks the present text to be checked.
void askForCheck(project::PanelState& state, const TurningOutcome& outcome, std::size_t setup);

}  // namespace lathelier::turning_panel
