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
    void floatOver(const QRect& window);             ///< in a window of its own, smaller than and beside `window`

    QAction& showAction() { return *show_; }  ///< of the View menu; closes nothing

signals:
    void showRequested();
    void panelMade(lathelier::PanelBase* panel);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void followFloating();

    Session& session_;
    PanelFacts facts_;
    PanelBase* panel_ = nullptr;
    QAction* show_;
    QWidget* noTitle_;  ///< title bar while it is docked: the title stands in the tab, or in the bar of questions
};

}  // namespace lathelier
