// What the window, the menus and the report have to know of a panel.
#pragma once

#include <QString>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/core/texts.h"
#include "engine/project/project.h"
#include "engine/report/document.h"

namespace lathelier {

class PanelBase;
class ScanStore;
class Session;

/// One line of the panel table (app/gui/panels.cpp); menu, dock, layouts and reports follow from it.
struct PanelFacts {
    std::string id;  ///< key in the project, the layouts and the settings: "compare"
    Text title;
    QString icon;                         ///< name in resources/icons
    std::vector<std::string> workspaces;  ///< ids: "inspection"
    std::function<PanelBase*(Session&)> make;

    /// The panel's part of a report without any widget or display; blocks. Throws what the engine throws.
    std::function<Document(const PanelState&, ScanStore&, const Language&, const Progress&)> report;
};

/// An input of a panel, given by a file.
struct InputRole {
    std::string role;  ///< key in PanelState::inputs: "reference"
    Text label;
    Text hint;  ///< what belongs here, for tooltip and empty state
    bool required = true;
};

/// The left column of a panel.
struct PanelInputs {
    std::vector<InputRole> roles;
    Text files;        ///< name of the kind of file: "Point clouds and meshes"
    QString patterns;  ///< "*.xyz *.ply"
    std::vector<FieldInfo> fields;
    Values defaults;  ///< of the fields
    Text invitation;  ///< the one sentence of the empty state
};

/// A way to write the result to a file. The label stands in the Export menu.
struct PanelExport {
    QString label;
    QString filter;                                  ///< "CSV (*.csv)"
    QString suffix;                                  ///< "csv"
    std::function<void(const QString& path)> write;  ///< throws Error
};

}  // namespace lathelier
