#include "widgets/drawing/sheet_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSvgRenderer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "engine/drawing/drawing_svg.h"

namespace lathelier::drawing_panel {
namespace {

constexpr double kMargin_px = 8;
constexpr double kMostZoom = 40;
constexpr double kStep = 1.25;
constexpr double kStepAngle = 120;  // of one notch of a wheel
constexpr int kMove_px = 40;

}  // namespace

SheetView::SheetView(QWidget* parent) : QWidget(parent), svg_(std::make_unique<QSvgRenderer>())
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(60, 40);
}

SheetView::~SheetView() = default;

void SheetView::setDrawing(const drawing::Drawing& drawing)
{
    const drawing::Box sheet = drawing::sheetBox(drawing.sheet);
    const QSizeF paper_mm(sheet.width_mm(), sheet.height_mm());
    svg_->load(QByteArray::fromStdString(drawing::toSvg(drawing)));
    if (paper_mm != paper_mm_) {
        paper_mm_ = paper_mm;
        fit();
    }
    update();
}

QRectF SheetView::sheetRect() const
{
    if (paper_mm_.isEmpty()) return {};
    const QSizeF room(std::max(1.0, width() - 2 * kMargin_px), std::max(1.0, height() - 2 * kMargin_px));
    const QSizeF size = paper_mm_.scaled(room, Qt::KeepAspectRatio) * zoom_;
    const QPointF middle(width() / 2.0, height() / 2.0);
    return {middle - QPointF(middle_.x() * size.width(), middle_.y() * size.height()), size};
}

void SheetView::fit()
{
    zoom_ = 1;
    middle_ = {0.5, 0.5};
    update();
}

void SheetView::zoomBy(double factor, const QPointF& about)
{
    const QRectF before = sheetRect();
    if (before.isEmpty()) return;
    const QPointF at((about.x() - before.left()) / before.width(), (about.y() - before.top()) / before.height());
    zoom_ = std::clamp(zoom_ * factor, 1.0, kMostZoom);
    if (zoom_ == 1) return fit();
    const QRectF after = sheetRect();
    moveBy(about - (after.topLeft() + QPointF(at.x() * after.width(), at.y() * after.height())));
}

void SheetView::moveBy(const QPointF& by)
{
    const QRectF sheet = sheetRect();
    if (sheet.isEmpty() || zoom_ == 1) return;
    middle_ -= QPointF(by.x() / sheet.width(), by.y() / sheet.height());
    middle_ = {std::clamp(middle_.x(), 0.0, 1.0), std::clamp(middle_.y(), 0.0, 1.0)};
    update();
}

void SheetView::paintEvent(QPaintEvent*)
{
    const QRectF sheet = sheetRect();
    if (sheet.isEmpty()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    for (int soft = 4; soft >= 1; --soft) {
        painter.setBrush(QColor(0, 0, 0, 12));
        painter.drawRoundedRect(sheet.adjusted(-soft, -soft, soft, soft), soft, soft);
    }
    painter.fillRect(sheet, Qt::white);
    svg_->render(&painter, sheet);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 60), 1));
    painter.drawRect(sheet);
    if (hasFocus() && !property("smallView").toBool()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void SheetView::wheelEvent(QWheelEvent* event)
{
    zoomBy(std::pow(kStep, event->angleDelta().y() / kStepAngle), event->position());
    event->accept();
}

void SheetView::mousePressEvent(QMouseEvent* event)
{
    dragged_ = event->localPos();
    if (event->button() == Qt::LeftButton && zoom_ > 1) setCursor(Qt::ClosedHandCursor);
}

void SheetView::mouseMoveEvent(QMouseEvent* event)
{
    if (!(event->buttons() & Qt::LeftButton)) return;
    moveBy(event->localPos() - dragged_);
    dragged_ = event->localPos();
}

void SheetView::mouseReleaseEvent(QMouseEvent*)
{
    unsetCursor();
}

void SheetView::mouseDoubleClickEvent(QMouseEvent*)
{
    fit();
}

void SheetView::keyPressEvent(QKeyEvent* event)
{
    const QPointF middle(width() / 2.0, height() / 2.0);
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal: return zoomBy(kStep, middle);
        case Qt::Key_Minus: return zoomBy(1 / kStep, middle);
        case Qt::Key_Home:
        case Qt::Key_0: return fit();
        default: break;
    }
    const bool still = zoom_ == 1;  // the arrows are then for the views
    if (!still && event->key() == Qt::Key_Left) return moveBy({kMove_px, 0});
    if (!still && event->key() == Qt::Key_Right) return moveBy({-kMove_px, 0});
    if (!still && event->key() == Qt::Key_Up) return moveBy({0, kMove_px});
    if (!still && event->key() == Qt::Key_Down) return moveBy({0, -kMove_px});
    QWidget::keyPressEvent(event);
}

void SheetView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    update();
}

}  // namespace lathelier::drawing_panel
