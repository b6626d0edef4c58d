#include "app/gui/panel_dock.h"

#include <QAction>
#include <QEvent>

#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

class NoTitle : public QWidget {
public:
    using QWidget::QWidget;
    QSize sizeHint() const override { return {0, 0}; }
    QSize minimumSizeHint() const override { return {0, 0}; }
};

constexpr double floatingShare = 0.7;  // of the window's width and height
constexpr int floatingShift_px = 48;   // that it is seen to lie over the window

}  // namespace

PanelDock::PanelDock(Session& session, const PanelFacts& facts, QWidget* parent)
    : QDockWidget(parent), session_(session), facts_(facts), show_(new QAction(this)), noTitle_(new NoTitle(this))
{
    connect(show_, &QAction::triggered, this, &PanelDock::showRequested);
    connect(this, &QDockWidget::topLevelChanged, this, &PanelDock::followFloating);
    setObjectName(QString::fromStdString("dock_" + facts.id));  // saved layouts know it by this name
    setWindowIcon(icon(facts.icon));
    followFloating();
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

void PanelDock::followFloating()
{
    setTitleBarWidget(isFloating() ? nullptr : noTitle_);
}

void PanelDock::floatOver(const QRect& window)
{
    setFloating(true);
    const QSize size = (QSizeF(window.size()) * floatingShare).toSize();
    QRect place(QPoint(0, 0), size);
    place.moveCenter(window.center() + QPoint(floatingShift_px, floatingShift_px));
    setGeometry(place);
    show();
    raise();
    activateWindow();
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
