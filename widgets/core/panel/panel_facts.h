// What the window, the menus and the report have to know of a panel.
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

namespace lathelier {

class PanelBase;
class Session;
class Stores;

/// An arrangement of panels for one kind of work; its panels stand together.
struct Workspace {
    std::string id;  ///< key in the project and the settings
    Text title;      ///< what people read
    QString icon;    ///< name in resources/icons
    int order = 0;   ///< of the bar, ascending
};

/// An input of a panel, given by a file, or by several that belong together.
struct InputRole {
    std::string role;            ///< key in PanelState::inputs: "reference"
    Text label;                  ///< what people read
    Text hint;                   ///< what belongs here, for tooltip and empty state
    bool required = true;        ///< without it nothing can be computed
    bool several = false;        ///< more files follow under the keys "role.2", "role.3"…
    io::FileKinds kinds = {};    ///< for its file dialog, and what a file may leave open besides ImportOptions
    std::string item_kind = {};  ///< of items of the project that may stand in place of a file; empty: files only
    bool takes_next = false;     ///< one more file for a panel whose inputs are all there goes here: the next part
};

/// One line of the panel table (app/gui/panels.cpp); menu, dock, layouts and reports follow from it.
struct PanelFacts {
    std::string id;                     ///< key in the report, the layouts and the settings: "compare"
    Text title;                         ///< what people read, in menus, tabs and reports
    QString icon;                       ///< name in resources/icons
    std::vector<Workspace> workspaces;  ///< that it is in, its own first
    std::function<PanelBase*(Session&)> make;

    /// The panel's part of a report without any widget or display; blocks. Throws what the engine throws.
    std::function<report::Document(const project::PanelState&, Stores&, const Language&, const Progress&)> report;

    /// Key of the panel's state in the project; empty: the id. Panels with the same one work on one state together.
    std::string state = {};

    /// The kinds of file that it works on: such a file opens this panel, and its workspace with it.
    io::FileKinds kinds = {};

    /// The inputs that are not there and without which nothing can be computed; none: as missingOf(roles).
    std::function<std::vector<Text>(const project::PanelState&)> missing = {};

    /// Whether the state holds files that this panel works on; none: when it holds any.
    std::function<bool(const project::PanelState&)> hasWork = {};

    /// What it takes, in the order on screen: the window lists the project's data by it.
    std::vector<InputRole> roles = {};

    /// The input that takes what another panel made, by the kind of the item.
    std::map<std::string, std::string> item_inputs = {};

    /// Roles of the inputs that change from part to part: left out of a recipe.
    std::vector<std::string> part_inputs = {};

    const std::string& stateKey() const { return state.empty() ? id : state; }
};

bool hasWork(const PanelFacts& facts, const project::PanelState& state);

/// The kinds of all roles, each once.
io::FileKinds kindsOf(const std::vector<InputRole>& roles);

/// The files of a role, in order.
std::vector<project::Source> sourcesOf(const project::PanelState& state, const InputRole& role);

/// Puts `sources` in place of the files of a role.
void setSources(project::PanelState& state, const InputRole& role, const std::vector<project::Source>& sources);

/// What PanelFacts::missing is for a panel that needs all its required inputs.
std::function<std::vector<Text>(const project::PanelState&)> missingOf(const std::vector<InputRole>& roles);

/// The left column of a panel.
struct PanelInputs {
    std::vector<InputRole> roles;   ///< in the order on screen
    std::vector<FieldInfo> fields;  ///< of the form, in the order on screen
    Values defaults;                ///< of the fields
    Text invitation;                ///< the one sentence of the empty state
};

/// Something that a panel can do, for the window's list of all commands.
struct PanelCommand {
    QString path;               ///< "Input › Tolerance"
    std::function<void()> run;  ///< does nothing when the panel is gone
};

/// A way to write the result to a file. The label stands in the Export menu.
struct PanelExport {
    QString label;                                   ///< what people read
    QString filter;                                  ///< "CSV (*.csv)"
    QString suffix;                                  ///< "csv"
    std::function<void(const QString& path)> write;  ///< throws Error
};

}  // namespace lathelier
