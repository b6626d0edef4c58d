#include "app/gui/panel_dock.h"

#include <QAction>
#include <QEvent>

#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {

PanelDock::PanelDock(Session& session, const PanelFacts& facts, QWidget* parent)
    : QDockWidget(parent), session_(session), facts_(facts), show_(new QAction(this))
{
    connect(show_, &QAction::triggered, this, [this] {
        show();
        raise();
        panel().setFocus();
    });
    setObjectName(QString::fromStdString("dock_" + facts.id));  // saved layouts know it by this name
    setWindowIcon(icon(facts.icon));
    retranslate();
}

PanelBase& PanelDock::panel()
{
    if (!panel_) {
        panel_ = facts_.make(session_);
        setWidget(panel_);
        emit panelMade(panel_);
    }
    return *panel_;
}

void PanelDock::setTitleSeen(bool seen)
{
    QWidget* empty = titleBarWidget();
    if (!seen && !empty) setTitleBarWidget(new QWidget(this));
    if (seen && empty) {
        setTitleBarWidget(nullptr);
        empty->deleteLater();
    }
}

void PanelDock::showEvent(QShowEvent* event)
{
    panel();
    QDockWidget::showEvent(event);
}

void PanelDock::retranslate()
{
    setWindowTitle(screenText(facts_.title));
    show_->setText(windowTitle());
    show_->setIcon(icon(facts_.icon));
}

void PanelDock::changeEvent(QEvent* event)
{
    QDockWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier
