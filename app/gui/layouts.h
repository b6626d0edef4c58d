// Arrangements of docks: one for each workspace, kept between runs.
#pragma once

#include <QMainWindow>
#include <string>
#include <vector>

#include "app/gui/panel_dock.h"

namespace lathelier {

/// The docks of a workspace: those whose own it is first.
std::vector<PanelDock*> docksIn(const std::vector<PanelDock*>& docks, const std::string& workspace);

/// Arranges the docks of a window. Whatever a saved arrangement says, the active panel ends up visible.
class Layouts {
public:
    Layouts(QMainWindow& window, const std::vector<PanelDock*>& docks, QDockWidget& log, QDockWidget& data);

    const std::string& workspace() const { return workspace_; }

    /// Saves the arrangement of the present workspace and shows that of `id`. `active`: its panel must be seen;
    /// nullptr: any one of the workspace.
    void enter(const std::string& id, PanelDock* active);

    void save() const;              ///< of the present workspace
    void reset(PanelDock* active);  ///< the arrangement a workspace has at first

    /// Shows and raises `active`, or the first panel of the workspace when none is seen; brings back floating docks
    /// that lie on no screen.
    void ensureSeen(PanelDock* active);

private:
    void hideAll();
    void arrangeAsAtFirst();
    bool restore();

    QMainWindow& window_;
    std::vector<PanelDock*> docks_;
    QDockWidget& log_;
    QDockWidget& data_;
    std::string workspace_;
};

}  // namespace lathelier
