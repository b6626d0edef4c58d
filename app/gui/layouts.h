// Arrangements of docks: one for each question, kept between runs.
#pragma once

#include <QMainWindow>
#include <string>
#include <vector>

#include "app/gui/panel_dock.h"

namespace lathelier {

/// The docks of a question, in the order of the panel table.
std::vector<PanelDock*> docksIn(const std::vector<PanelDock*>& docks, const std::string& question);

/// Arranges the docks of a window. Whatever a saved arrangement says, the active panel ends up visible.
class Layouts {
public:
    Layouts(QMainWindow& window, const std::vector<PanelDock*>& docks, QDockWidget& log, QDockWidget& data);

    const std::string& question() const { return question_; }

    /// Saves the arrangement of the present question and shows that of `id`. `active`: its panel must be seen;
    /// nullptr: any one of the question.
    void enter(const std::string& id, PanelDock* active);

    void save() const;              ///< of the present question
    void reset(PanelDock* active);  ///< the arrangement a question has at first

    /// Shows and raises `active`, or the first panel of the question when none is seen; brings back floating docks
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
    std::string question_;
};

}  // namespace lathelier
