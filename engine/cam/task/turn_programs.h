// Which program each clamping has: the planned one, one that came back corrected or from a file, or one that was
// changed by hand; and whether the checked text is the present one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/cam/plan_programs.h"
#include "engine/cam/task/turn_question.h"
#include "engine/project/project.h"
#include "engine/task/task.h"

namespace lathelier::cam {

struct TurnOutcome;

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

/// Programs used in place of the planned ones; fills in `programs` and adds to the sources. Errors: those of the
/// readers; itemNotThere.
std::vector<GivenProgram> chooseProgram(TurnOutcome& outcome, const TurningPlan& planned,
                                        const project::PanelState& state, Stores& stores, task::Sources& sources,
                                        const Progress& progress);

/// Programs that may be handed on, each under the part's name so that the next one takes its place, and the response of
/// each section; `part` is their index.
std::vector<task::Product> productsOf(const std::shared_ptr<const TurnOutcome>& outcome, const Language& language);

/// Whether this program is checked without findings and all its tools are known, so that it may be handed on and
/// written.
bool isSound(const TurnOutcome& outcome, std::size_t setup);

/// The state of the question with the program of this clamping changed by hand; none: as it was.
void setDraft(project::PanelState& state, const TurnOutcome& outcome, std::size_t setup,
              const std::optional<std::string>& utf8);

/// Marks the present text to be checked.
void askForCheck(project::PanelState& state, const TurnOutcome& outcome, std::size_t setup);

}  // namespace lathelier::cam
