// A dock that holds one panel and makes it when it is first seen.
#pragma once

#include <QAction>
#include <QDockWidget>

#include "widgets/core/panel/panel_base.h"

namespace lathelier {

class PanelDock : public QDockWidget {
    Q_OBJECT
public:
    PanelDock(Session& session, const PanelFacts& facts, QWidget* parent);

    const PanelFacts& facts() const { return facts_; }
    PanelBase& panel();                              ///< makes it when needed
    PanelBase* madePanel() const { return panel_; }  ///< nullptr: never seen so far
    void setTitleSeen(bool seen);                    ///< presenter mode hides the title bar

    QAction& showAction() { return *show_; }  ///< of the View menu: shows and raises, closes nothing

signals:
    void panelMade(lathelier::PanelBase* panel);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    Session& session_;
    PanelFacts facts_;
    PanelBase* panel_ = nullptr;
    QAction* show_;
};

}  // namespace lathelier
