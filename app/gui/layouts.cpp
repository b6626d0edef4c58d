#include "app/gui/layouts.h"

#include <QGuiApplication>
#include <QScreen>
#include <QSettings>
#include <algorithm>
#include <iterator>

namespace lathelier {
namespace {

constexpr int layoutVersion = 3;  // counts up when docks are renamed, or stand elsewhere

QString settingsKey(const std::string& question)
{
    return QString::fromStdString("layouts/" + question);
}

bool isOnAScreen(const QWidget& widget)
{
    const auto screens = QGuiApplication::screens();
    return std::any_of(screens.begin(), screens.end(), [&](const QScreen* screen) {
        const QRect seen = screen->availableGeometry().intersected(widget.frameGeometry());
        return seen.width() > 50 && seen.height() > 30;
    });
}

}  // namespace

std::vector<PanelDock*> docksIn(const std::vector<PanelDock*>& docks, const std::string& question)
{
    std::vector<PanelDock*> here;
    std::copy_if(docks.begin(), docks.end(), std::back_inserter(here),
                 [&](const PanelDock* dock) { return dock->facts().question.id == question; });
    return here;
}

Layouts::Layouts(QMainWindow& window, const std::vector<PanelDock*>& docks, QDockWidget& log, QDockWidget& data)
    : window_(window), docks_(docks), log_(log), data_(data)
{
    for (PanelDock* dock : docks_) {
        window_.addDockWidget(Qt::TopDockWidgetArea, dock);
        dock->hide();
    }
    window_.addDockWidget(Qt::BottomDockWidgetArea, &log_);
    log_.hide();
    window_.setCorner(Qt::TopLeftCorner, Qt::LeftDockWidgetArea);  // over the whole height, beside the panels
    window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window_.addDockWidget(Qt::LeftDockWidgetArea, &data_);
    data_.hide();
}

void Layouts::enter(const std::string& id, PanelDock* active)
{
    if (!question_.empty()) save();
    question_ = id;
    if (!restore()) arrangeAsAtFirst();
    for (PanelDock* dock : docks_)
        if (dock->facts().question.id != id) dock->hide();
    ensureSeen(active);
}

void Layouts::save() const
{
    QSettings().setValue(settingsKey(question_), window_.saveState(layoutVersion));
}

bool Layouts::restore()
{
    const QByteArray state = QSettings().value(settingsKey(question_)).toByteArray();
    if (state.isEmpty()) return false;
    hideAll();
    return window_.restoreState(state, layoutVersion);
}

void Layouts::reset(PanelDock* active)
{
    QSettings().remove(settingsKey(question_));
    arrangeAsAtFirst();
    ensureSeen(active);
}

/// Before docks are moved: some that are seen side by side for a moment would widen the window.
void Layouts::hideAll()
{
    for (PanelDock* dock : docks_) dock->hide();
    log_.hide();
    data_.hide();
}

void Layouts::arrangeAsAtFirst()
{
    hideAll();
    for (PanelDock* dock : docks_) {
        dock->setFloating(false);
        window_.removeDockWidget(dock);
    }
    for (PanelDock* dock : docks_) {
        if (dock->facts().question.id == question_) continue;
        window_.addDockWidget(Qt::TopDockWidgetArea, dock);
        dock->hide();
    }
    PanelDock* first = nullptr;
    for (PanelDock* dock : docksIn(docks_, question_)) {
        window_.addDockWidget(Qt::TopDockWidgetArea, dock);
        if (first) window_.tabifyDockWidget(first, dock);
        dock->show();
        if (!first) first = dock;
    }
    log_.setFloating(false);
    window_.removeDockWidget(&log_);
    window_.addDockWidget(Qt::BottomDockWidgetArea, &log_);
    log_.hide();
    data_.setFloating(false);
    window_.removeDockWidget(&data_);
    window_.addDockWidget(Qt::LeftDockWidgetArea, &data_);
    data_.hide();
    if (first) first->raise();
}

void Layouts::ensureSeen(PanelDock* active)
{
    for (PanelDock* dock : docks_)
        if (dock->isFloating() && !dock->isHidden() && !isOnAScreen(*dock)) dock->setFloating(false);
    if (!active || active->facts().question.id != question_) {
        active = nullptr;
        for (PanelDock* dock : docksIn(docks_, question_))
            if (!active || (active->isHidden() && !dock->isHidden())) active = dock;
    }
    if (!active) return;
    active->show();
    active->raise();
}

}  // namespace lathelier
