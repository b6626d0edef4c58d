// Static description of a panel for the window, the menus and the report.
#pragma once

#include <QString>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/core/texts.h"
#include "engine/io/file_kind.h"
#include "engine/project/project.h"
#include "engine/report/document.h"
#include "engine/walk/place.h"

namespace lathelier::task {
struct Task;
}

namespace lathelier {

class PanelBase;
class Session;
class Stores;

/// A question of the window: one box of the bar at the top; its panels are docked together.
struct Question {
    std::string id;       ///< key in the project and the settings
    Text title;           ///< shown text
    QString icon;         ///< icon name in resources/icons
    int order = 0;        ///< order in the bar, ascending
    bool beside = false;  ///< it stands beside the chain from the scan to the proof
};

/// The question with this id. Precondition: there is one.
const Question& questionOf(const std::string& id);

/// An input of a panel, given by a file, or by several that belong together.
struct InputRole {
    std::string role;            ///< key in PanelState::inputs: "reference"
    Text label;                  ///< shown text
    Text hint;                   ///< description for tooltip and empty state
    bool required = true;        ///< required for the computation
    bool several = false;        ///< more files follow under the keys "role.2", "role.3"…
    io::FileKinds kinds = {};    ///< kinds for its file dialog and reading options besides ImportOptions
    std::string item_kind = {};  ///< kind of project items accepted instead of a file; empty: files only
    bool takes_next = false;     ///< a further file for a panel with all inputs given is assigned here: the next part
};

/// One line of the panel table (app/gui/panels.cpp); menu, dock, layouts and reports derive from it.
struct PanelFacts {
    std::string id;     ///< key in the report, the layouts and the settings: "compare"
    Text title;         ///< shown in menus, tabs and reports
    QString icon;       ///< icon name in resources/icons
    Question question;  ///< under which it stands
    std::function<PanelBase*(Session&)> make;

    /// The panel's part of a report without any widget or display; blocks. Throws the exceptions of the engine.
    /// `sources` has the notes of what was filled in.
    std::function<report::Document(const project::PanelState&, Stores&, task::Sources& sources, const Language&,
                                   const Progress&)>
        report;

    /// The task that it stands over; nullptr: none.
    const task::Task* task = nullptr;

    /// Answers a complete state; none: the panel answers by itself.
    std::function<walk::PlaceAnswer(const project::PanelState&, Stores&, task::Sources&, const Progress&)> answer = {};

    /// Values that the panel begins with in place of the task's defaults.
    Values begins_with = {};

    /// Key of the panel's state in the project; empty: the id. Panels with equal keys share one state.
    std::string state = {};

    /// Accepted kinds of file: such a file opens this panel and its question.
    io::FileKinds kinds = {};

    /// Kinds of file that belong here when one is opened alone, although other panels accept them too.
    io::FileKinds alone = {};

    /// Missing required inputs; none: missingOf(roles).
    std::function<std::vector<Text>(const project::PanelState&)> missing = {};

    /// Whether the state contains inputs for this panel; none: true with any input.
    std::function<bool(const project::PanelState&)> has_work = {};

    /// Input roles in display order, for the window's list of the project's data.
    std::vector<InputRole> roles = {};

    /// Input role by kind of item made by another panel.
    std::map<std::string, std::string> item_inputs = {};

    /// Roles of inputs specific to one part, which a recipe excludes; of a panel of a task those that the task says.
    std::vector<std::string> part_inputs = {};

    /// Its answer stands for its question, before those of the panels before it.
    bool speaks_first = false;

    const std::string& stateKey() const { return state.empty() ? id : state; }
};

/// The panels as places of a part: those of walk::partPlaces() with what their panels ask and answer, then the others.
std::vector<walk::Place> placesOf(const std::vector<PanelFacts>& table);

bool hasWork(const PanelFacts& facts, const project::PanelState& state);

/// The kinds of all roles without duplicates.
io::FileKinds kindsOf(const std::vector<InputRole>& roles);

/// The files of a role, in order.
std::vector<project::Source> sourcesOf(const project::PanelState& state, const InputRole& role);

/// Replaces the files of a role by `sources`.
void setSources(project::PanelState& state, const InputRole& role, const std::vector<project::Source>& sources);

/// Default of PanelFacts::missing: the required inputs not given.
std::function<std::vector<Text>(const project::PanelState&)> missingOf(const std::vector<InputRole>& roles);

/// The left column of a panel.
struct PanelInputs {
    std::vector<InputRole> roles;   ///< in display order
    std::vector<FieldInfo> fields;  ///< of the form, in display order
    Values defaults;                ///< default values of the fields
    Text invitation;                ///< sentence of the empty state
    /// Tables by the role of the file that stands in their place: hidden while they are empty and it is given.
    std::map<std::string, std::string> tables = {};
};

/// A command of a panel, for the command palette.
struct PanelCommand {
    QString path;               ///< path in the palette, "Input › Tolerance"
    std::function<void()> run;  ///< no effect after the panel is destroyed
};

/// A way to write the result to a file. The label appears in the Export menu.
struct PanelExport {
    QString label;                                   ///< shown text
    QString filter;                                  ///< filter of the file dialog, "CSV (*.csv)"
    QString suffix;                                  ///< default suffix, "csv"
    std::function<void(const QString& path)> write;  ///< writes the file; throws Error
    bool may_replace_input = false;                  ///< saves an input that was changed here
};

}  // namespace lathelier
