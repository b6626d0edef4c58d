#include "widgets/core/panel/primary_views.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QStyle>
#include <algorithm>
#include <cmath>
#include <functional>

#include "widgets/core/panel/view_frame.h"

namespace lathelier {
namespace {

constexpr int frameGap_px = 4;
constexpr int stripFrom_chars = 105;  // panel width in characters below which the small views become tabs
constexpr double stripShare = 0.27;   // width of the strip relative to the panel
constexpr int leastStrip_chars = 26;
constexpr int mostStrip_chars = 60;
constexpr double flattest = 0.36;     // height of a small view with its caption to the width of the strip, at least
constexpr double twoColumns = 1.5;    // width of a strip of two columns to that of one
constexpr double widePair = 1.15;     // width to height from which two large views stand side by side
constexpr double smallAspect = 0.78;  // height of a small view to its width, at most

}  // namespace

PrimaryViews::PrimaryViews(QWidget* parent) : QWidget(parent), tabs_(new QTabBar(this))
{
    setFocusPolicy(Qt::StrongFocus);
    tabs_->setObjectName("viewTabs");
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->hide();
    connect(tabs_, &QTabBar::tabBarClicked, this, [this](int index) {
        const std::vector<ViewFrame*> all = shown();
        if (index >= 0 && index < static_cast<int>(all.size())) setPrimary(all[static_cast<std::size_t>(index)]->key());
    });
}

void PrimaryViews::add(const QString& key, QWidget* view)
{
    auto* frame = new ViewFrame(key, view, this);
    frames_.push_back(frame);
    if (!primary_) primary_ = frame;
    connect(frame, &ViewFrame::enlargeRequested, this, [this, frame] {
        setShowsAll(false);
        setPrimary(frame->key());
    });
    connect(frame, &ViewFrame::allRequested, this, [this] { setShowsAll(!all_); });
    arrange();
}

ViewFrame* PrimaryViews::find(const QString& key) const
{
    const auto found =
        std::find_if(frames_.begin(), frames_.end(), [&](const ViewFrame* frame) { return frame->key() == key; });
    return found == frames_.end() ? nullptr : *found;
}

std::vector<ViewFrame*> PrimaryViews::shown() const
{
    std::vector<ViewFrame*> result;
    for (ViewFrame* frame : frames_)
        if (frame->isAvailable()) result.push_back(frame);
    return result;
}

void PrimaryViews::setTitle(const QString& key, const QString& title)
{
    if (ViewFrame* frame = find(key)) frame->setTitle(title);
    arrange();
}

void PrimaryViews::setAvailable(const QString& key, bool available)
{
    ViewFrame* frame = find(key);
    if (!frame || frame->isAvailable() == available) return;
    frame->setAvailable(available);
    arrange();
}

QStringList PrimaryViews::keys() const
{
    QStringList result;
    for (const ViewFrame* frame : shown()) result << frame->key();
    return result;
}

QString PrimaryViews::title(const QString& key) const
{
    const ViewFrame* frame = find(key);
    return frame ? frame->title() : QString();
}

QString PrimaryViews::primary() const
{
    return primary_ ? primary_->key() : QString();
}

void PrimaryViews::setPrimary(const QString& key)
{
    ViewFrame* frame = find(key);
    if (!frame || !frame->isAvailable() || frame == primary_) return;
    primary_ = frame;
    arrange();
    if (presenting_)
        setFocus();  // otherwise a plot would handle the arrow keys
    else
        primary_->view()->setFocus();
    emit primaryChanged(key);
}

void PrimaryViews::setBeside(const QString& key)
{
    ViewFrame* const frame = find(key);
    if (frame == beside_) return;
    beside_ = frame;
    arrange();
}

bool PrimaryViews::isPair() const
{
    return beside_ && beside_ != primary_ && beside_->isAvailable() && !presenting_ && !all_;
}

/// The primary view, behind or below the one beside it.
void PrimaryViews::placeLarge(const QRect& room)
{
    QRect main = room;
    if (isPair()) {
        QRect first = room;
        if (room.width() > widePair * room.height()) {
            first.setWidth((room.width() - frameGap_px) / 2);
            main.setLeft(first.right() + 1 + frameGap_px);
        } else {
            first.setHeight((room.height() - frameGap_px) / 2);
            main.setTop(first.bottom() + 1 + frameGap_px);
        }
        beside_->setGeometry(first);
        beside_->show();
    }
    primary_->setGeometry(main);
    primary_->show();
}

void PrimaryViews::setShowsAll(bool all)
{
    if (all == all_) return;
    all_ = all;
    arrange();
}

void PrimaryViews::setPresenting(bool presenting)
{
    presenting_ = presenting;
    arrange();
    if (presenting) setFocus();
}

void PrimaryViews::step(int by)
{
    const std::vector<ViewFrame*> all = shown();
    if (all.empty()) return;
    const auto now = std::find(all.begin(), all.end(), primary_);
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    const std::ptrdiff_t place = now == all.end() ? 0 : now - all.begin();
    setPrimary(all[static_cast<std::size_t>(((place + by) % count + count) % count)]->key());
}

QSize PrimaryViews::minimumSizeHint() const
{
    return {fontMetrics().averageCharWidth() * 40, fontMetrics().height() * 14};
}

/// Views keep their parent: a reparented 3-D view would lose its OpenGL resources.
void PrimaryViews::arrange()
{
    std::vector<ViewFrame*> all = shown();
    const int chars = fontMetrics().averageCharWidth();
    if (primary_ && !primary_->isAvailable() && !all.empty()) primary_ = all.front();
    const bool alone = presenting_ || all.size() < 2;
    const bool narrow = !alone && width() < stripFrom_chars * chars;
    for (ViewFrame* frame : frames_) {
        const bool in_pair = isPair() && frame == beside_;
        const bool large = frame == primary_ || in_pair || (all_ && !narrow && !alone);
        frame->setSmall(!large);
        frame->setCaptionVisible((!narrow || isPair()) && !alone);
        if (!frame->isAvailable() || ((narrow || alone) && frame != primary_ && !in_pair)) frame->hide();
    }
    int top = 0;
    tabs_->setVisible(narrow);
    if (narrow) {
        const QSignalBlocker quiet(tabs_);
        while (tabs_->count() > static_cast<int>(all.size())) tabs_->removeTab(tabs_->count() - 1);
        while (tabs_->count() < static_cast<int>(all.size())) tabs_->addTab({});
        for (int i = 0; i < tabs_->count(); ++i) {
            tabs_->setTabText(i, all[static_cast<std::size_t>(i)]->title());
            if (all[static_cast<std::size_t>(i)] == primary_) tabs_->setCurrentIndex(i);
        }
        tabs_->setGeometry(0, 0, width(), tabs_->sizeHint().height());
        top = tabs_->height();
    }
    const QRect room(0, top, width(), height() - top);
    const auto place = [](ViewFrame* frame, const QRect& where) {
        frame->setGeometry(where);
        frame->show();
    };
    if (!primary_ || room.isEmpty()) return;
    if (narrow || alone) return placeLarge(room);
    if (all_) {
        const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(all.size()))));
        const int rows = (static_cast<int>(all.size()) + columns - 1) / columns;
        for (int i = 0; i < static_cast<int>(all.size()); ++i) {
            const int inRow = i / columns < rows - 1 ? columns : static_cast<int>(all.size()) - columns * (rows - 1);
            const int w = (room.width() - frameGap_px * (inRow - 1)) / inRow;
            const int h = (room.height() - frameGap_px * (rows - 1)) / rows;
            place(all[static_cast<std::size_t>(i)],
                  QRect((i % columns) * (w + frameGap_px), room.top() + (i / columns) * (h + frameGap_px), w, h));
        }
        return;
    }
    int strip =
        std::clamp(static_cast<int>(stripShare * room.width()), leastStrip_chars * chars, mostStrip_chars * chars);
    const int count = static_cast<int>(all.size()) - (isPair() ? 2 : 1);
    if (count == 0) return placeLarge(room);
    const auto heightIn = [&](int rows) { return (room.height() - frameGap_px * (rows - 1)) / rows; };
    // Charts that would be too flat are placed in two columns.
    const int columns = heightIn(count) < flattest * strip ? 2 : 1;
    if (columns == 2) strip = static_cast<int>(twoColumns * strip);
    placeLarge(QRect(0, room.top(), room.width() - strip - frameGap_px, room.height()));
    const int width = (strip - frameGap_px * (columns - 1)) / columns;
    const int most = static_cast<int>(smallAspect * width) + primary_->captionHeight();
    const int each = std::min(most, heightIn((count + columns - 1) / columns));
    int number = 0;
    for (ViewFrame* frame : all) {
        if (frame == primary_ || (isPair() && frame == beside_)) continue;
        place(frame, QRect(room.width() - strip + number % columns * (width + frameGap_px),
                           room.top() + number / columns * (each + frameGap_px), width, each));
        ++number;
    }
}

void PrimaryViews::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

/// Receives keys not handled by the focused view.
void PrimaryViews::keyPressEvent(QKeyEvent* event)
{
    const bool forward =
        event->key() == Qt::Key_Right || event->key() == Qt::Key_Down || event->key() == Qt::Key_PageDown;
    const bool back = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up || event->key() == Qt::Key_PageUp;
    const std::vector<ViewFrame*> all = shown();
    const int number = event->key() - Qt::Key_0;
    if (presenting_ && (forward || back))
        step(forward ? 1 : -1);
    else if (number >= 1 && number <= std::min(9, static_cast<int>(all.size())) && event->modifiers() == Qt::NoModifier)
        setPrimary(all[static_cast<std::size_t>(number - 1)]->key());
    else
        QWidget::keyPressEvent(event);
}

void PrimaryViews::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange) arrange();
}

}  // namespace lathelier
