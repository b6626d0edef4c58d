#include "widgets/core/panel/view_frame.h"

#include <QApplication>
#include <QEvent>
#include <QMouseEvent>

namespace lathelier {
namespace {

constexpr double smallType = 0.7;  // font size of small views relative to the application's

}

ViewFrame::ViewFrame(const QString& key, QWidget* view, QWidget* parent)
    : QWidget(parent), key_(key), view_(view), caption_(new QLabel(this)), cover_(new QWidget(this))
{
    setObjectName("frame_" + key);
    view_->setParent(this);
    caption_->setObjectName("caption_" + key);
    caption_->setCursor(Qt::PointingHandCursor);
    caption_->installEventFilter(this);
    cover_->setObjectName("cover_" + key);
    cover_->setCursor(Qt::PointingHandCursor);
    cover_->setFocusPolicy(Qt::NoFocus);
    cover_->installEventFilter(this);
    cover_->hide();
    view_->show();
}

void ViewFrame::setTitle(const QString& title)
{
    caption_->setText(title);
    caption_->setToolTip(tr("Click: enlarge. Double click: all views."));
    cover_->setToolTip(title);
    cover_->setAccessibleName(title);
    view_->setAccessibleName(title);
}

void ViewFrame::setSmall(bool small)
{
    if (small_ == small) return;
    small_ = small;
    QFont font = caption_->font();
    font.setBold(!small);
    caption_->setFont(font);
    setTypeSize();
    for (QWidget* child : view_->findChildren<QWidget*>())
        if (child->property(onlyLarge).toBool()) child->setVisible(!small);
    QList<QWidget*> views = view_->findChildren<QWidget*>();
    for (QWidget* child : views << view_)
        if (child->property(smallView).isValid()) child->setProperty(smallView, small);
    cover_->setVisible(small);
    if (small) cover_->raise();
}

/// The resolve mask of the font lets the view follow the application's font except for the size.
void ViewFrame::setTypeSize()
{
    QFont type;
    if (small_.value_or(false)) type.setPointSizeF(QApplication::font().pointSizeF() * smallType);
    view_->setFont(type);
}

void ViewFrame::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange) setTypeSize();
}

void ViewFrame::setCaptionVisible(bool visible)
{
    caption_->setVisible(visible);
    arrange();
}

int ViewFrame::captionHeight() const
{
    return caption_->fontMetrics().height() + 4;
}

void ViewFrame::arrange()
{
    const int top = caption_->isVisibleTo(this) ? captionHeight() : 0;
    caption_->setGeometry(4, 0, width() - 8, captionHeight());
    const QRect room(0, top, width(), std::max(0, height() - top));
    view_->setGeometry(room);
    cover_->setGeometry(room);
    if (small_.value_or(false)) cover_->raise();
}

void ViewFrame::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

bool ViewFrame::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonRelease && static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton &&
        (watched == cover_ || small_.value_or(false)))
        emit enlargeRequested();
    else if (event->type() == QEvent::MouseButtonDblClick && watched == caption_)
        emit allRequested();
    else
        return QWidget::eventFilter(watched, event);
    return true;
}

}  // namespace lathelier
