#include "widgets/drawing/sheet_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSvgRenderer>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "engine/drawing/drawing_svg.h"

namespace lathelier::drawing_panel {
namespace {

constexpr double sheetMargin_px = 8;
constexpr double largestZoom = 40;
constexpr double zoomStep = 1.25;
constexpr double wheelNotchAngle = 120;  // angleDelta() of one wheel notch, eighths of a degree
constexpr int keyPan_px = 40;
constexpr double contourReach_px = 5;  // picking distance of a contour

}  // namespace

SheetView::SheetView(QWidget* parent)
    : QWidget(parent), field_(new QLineEdit(this)), svg_(std::make_unique<QSvgRenderer>())
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(60, 40);
    setMouseTracking(true);
    field_->setObjectName("dimension");
    field_->hide();
    field_->installEventFilter(this);
    connect(field_, &QLineEdit::returnPressed, this, [this] {
        const int label = fieldOf_;
        const QString text = field_->text();
        closeField();
        emit dimensionTyped(label, text);
    });
}

SheetView::~SheetView() = default;

void SheetView::setDrawing(const drawing::Drawing& drawing)
{
    const drawing::Box sheet = drawing::sheetBox(drawing.sheet);
    const QSizeF paper_mm(sheet.width_mm(), sheet.height_mm());
    svg_->load(QByteArray::fromStdString(drawing::toSvg(drawing)));
    drawing_ = drawing;
    closeField();  // its dimension may not exist any more
    if (paper_mm != paper_mm_) {
        paper_mm_ = paper_mm;
        fit();
    }
    update();
}

QRectF SheetView::sheetRect() const
{
    if (paper_mm_.isEmpty()) return {};
    const QSizeF room(std::max(1.0, width() - 2 * sheetMargin_px), std::max(1.0, height() - 2 * sheetMargin_px));
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
    zoom_ = std::clamp(zoom_ * factor, 1.0, largestZoom);
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
    if (!property("smallView").toBool()) paintMark(painter);
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
    zoomBy(std::pow(zoomStep, event->angleDelta().y() / wheelNotchAngle), event->position());
    event->accept();
}

void SheetView::mousePressEvent(QMouseEvent* event)
{
    dragged_ = pressed_ = event->localPos();
    moved_ = false;
    if (field_->isVisible()) closeField();
    if (event->button() == Qt::LeftButton && zoom_ > 1) setCursor(Qt::ClosedHandCursor);
}

void SheetView::mouseMoveEvent(QMouseEvent* event)
{
    if (!(event->buttons() & Qt::LeftButton)) {
        const bool over = dimensionAt(event->localPos()) || rowAt(event->localPos());
        return setCursor(over ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
    if ((event->localPos() - pressed_).manhattanLength() >= QApplication::startDragDistance()) moved_ = true;
    if (!moved_) return;
    moveBy(event->localPos() - dragged_);
    dragged_ = event->localPos();
}

void SheetView::mouseReleaseEvent(QMouseEvent* event)
{
    unsetCursor();
    if (event->button() != Qt::LeftButton || moved_) return;
    std::optional<std::size_t> row = rowAt(event->localPos());
    if (const auto label = dimensionAt(event->localPos())) {
        const drawing::DimensionTarget& target = drawing_.labels[*label].target;
        row = target.of == drawing::DimensionTarget::Of::Length ? target.rows.back() : target.rows.front();
        if (target.bore) row.reset();
    }
    emit rowClicked(row ? static_cast<int>(*row) : -1);
}

void SheetView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (const auto label = dimensionAt(event->localPos())) return emit dimensionActivated(static_cast<int>(*label));
    if (!rowAt(event->localPos())) fit();
}

void SheetView::contextMenuEvent(QContextMenuEvent* event)
{
    const bool by_key = event->reason() == QContextMenuEvent::Keyboard;
    const std::optional<std::size_t> row = by_key ? row_ : rowAt(event->pos());
    if (!row) return event->ignore();
    const QPolygonF& contour = rows_[*row];
    const QPointF middle = contour[contour.size() / 2];
    const double z_mm = by_key ? (contour.first().x() + contour.last().x()) / 2 : partOf(event->pos()).x();
    emit menuRequested(static_cast<int>(*row), z_mm,
                       by_key ? mapToGlobal(pixelOf(z_mm, middle.y()).toPoint()) : event->globalPos());
}

bool SheetView::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* const help = static_cast<QHelpEvent*>(event);
    if (const auto label = dimensionAt(help->pos()))
        QToolTip::showText(help->globalPos(), tr("A double click opens a field for another size"), this);
    else
        QToolTip::hideText();
    return true;
}

/// Escape and a click elsewhere cancel the edit.
bool SheetView::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == field_) {
        const bool escape =
            event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
        if (escape || event->type() == QEvent::FocusOut) closeField();
        if (escape) return true;
    }
    return QWidget::eventFilter(watched, event);
}

void SheetView::editDimension(std::size_t label, const QString& text, const QString& help)
{
    if (label >= drawing_.labels.size()) return;
    fieldOf_ = static_cast<int>(label);
    field_->setText(text);
    field_->setToolTip(help);
    field_->setAccessibleName(help);
    const QSize size(field_->fontMetrics().horizontalAdvance(text + "00000000"), field_->sizeHint().height());
    QRect place(QPoint(), size);
    place.moveCenter(pixelsOf(drawing_.labels[label]).center().toPoint());
    place.moveLeft(std::clamp(place.left(), 0, std::max(0, width() - place.width())));
    place.moveTop(std::clamp(place.top(), 0, std::max(0, height() - place.height())));
    field_->setGeometry(place);
    field_->selectAll();
    field_->show();
    field_->setFocus();
}

void SheetView::closeField()
{
    if (fieldOf_ < 0) return;
    fieldOf_ = -1;
    const bool had_focus = field_->hasFocus();
    field_->hide();
    if (had_focus) setFocus();
}

void SheetView::setRows(std::vector<QPolygonF> contours)
{
    rows_ = std::move(contours);
    if (row_ && *row_ >= rows_.size()) row_.reset();
    update();
}

void SheetView::markRow(std::optional<std::size_t> row)
{
    row_ = row && *row < rows_.size() ? row : std::nullopt;
    update();
}

QPointF SheetView::pixelOf(double z_mm, double radius_mm) const
{
    const QRectF sheet = sheetRect();
    const double scale = sheet.width() / std::max(1.0, paper_mm_.width()), factor = drawing_.scale.factor();
    return {sheet.left() + scale * (drawing_.origin_mm.x() + factor * z_mm),
            sheet.bottom() - scale * (drawing_.origin_mm.y() + factor * radius_mm)};
}

QPointF SheetView::partOf(const QPointF& pixel) const
{
    const QRectF sheet = sheetRect();
    const double scale = sheet.width() / std::max(1.0, paper_mm_.width()), factor = drawing_.scale.factor();
    return {((pixel.x() - sheet.left()) / scale - drawing_.origin_mm.x()) / factor,
            ((sheet.bottom() - pixel.y()) / scale - drawing_.origin_mm.y()) / factor};
}

QRectF SheetView::pixelsOf(const drawing::Label& label) const
{
    const QRectF sheet = sheetRect();
    const double scale = sheet.width() / std::max(1.0, paper_mm_.width());
    const drawing::Box box = boxOf(label);
    return {QPointF(sheet.left() + scale * box.left_mm, sheet.bottom() - scale * box.top_mm),
            QPointF(sheet.left() + scale * box.right_mm, sheet.bottom() - scale * box.bottom_mm)};
}

/// The row of the contour nearest to the pointer, else the row that contains it.
std::optional<std::size_t> SheetView::rowAt(const QPointF& pixel) const
{
    std::optional<std::size_t> found;
    double nearest = contourReach_px;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        for (const double side : {1.0, -1.0})
            for (int k = 0; k + 1 < rows_[i].size(); ++k) {
                const QPointF a = pixelOf(rows_[i][k].x(), side * rows_[i][k].y());
                const QPointF b = pixelOf(rows_[i][k + 1].x(), side * rows_[i][k + 1].y());
                const QPointF run = b - a, from = pixel - a;
                const double length = QPointF::dotProduct(run, run);
                const double share = length > 0 ? std::clamp(QPointF::dotProduct(from, run) / length, 0.0, 1.0) : 0.0;
                const QPointF off = from - share * run;
                const double away = std::sqrt(QPointF::dotProduct(off, off));
                if (away < nearest) {
                    nearest = away;
                    found = i;
                }
            }
    if (found) return found;
    const QPointF at = partOf(pixel);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const QRectF box = rows_[i].boundingRect();
        if (at.x() >= box.left() && at.x() <= box.right() && std::abs(at.y()) <= box.bottom()) return i;
    }
    return std::nullopt;
}

std::optional<std::size_t> SheetView::dimensionAt(const QPointF& pixel) const
{
    for (std::size_t i = 0; i < drawing_.labels.size(); ++i)
        if (drawing_.labels[i].target.of != drawing::DimensionTarget::Of::None &&
            pixelsOf(drawing_.labels[i]).adjusted(-2, -2, 2, 2).contains(pixel))
            return i;
    return std::nullopt;
}

void SheetView::paintMark(QPainter& painter) const
{
    if (!row_) return;
    QColor colour = palette().color(QPalette::Highlight);
    QPolygonF closed;
    for (const double side : {1.0, -1.0}) {
        QPolygonF line;
        for (const QPointF& point : rows_[*row_]) line << pixelOf(point.x(), side * point.y());
        painter.setPen(QPen(colour, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
        if (side < 0) std::reverse(line.begin(), line.end());
        closed << line;
    }
    colour.setAlpha(40);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(closed);
    colour.setAlpha(70);
    painter.setBrush(colour);
    for (const drawing::Label& label : drawing_.labels) {
        if (label.target.bore) continue;
        const auto& rows = label.target.rows;
        const bool of_length = label.target.of == drawing::DimensionTarget::Of::Length;
        const bool says = of_length ? !rows.empty() && rows.back() == *row_
                                    : std::find(rows.begin(), rows.end(), *row_) != rows.end();
        if (says) painter.drawRoundedRect(pixelsOf(label).adjusted(-2, -1, 2, 1), 2, 2);
    }
}

void SheetView::keyPressEvent(QKeyEvent* event)
{
    const QPointF middle(width() / 2.0, height() / 2.0);
    event->ignore();
    emit rowKeyPressed(event);
    if (event->isAccepted()) return;
    event->accept();
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal: return zoomBy(zoomStep, middle);
        case Qt::Key_Minus: return zoomBy(1 / zoomStep, middle);
        case Qt::Key_Home:
        case Qt::Key_0: return fit();
        default: break;
    }
    const bool still = zoom_ == 1;  // arrow keys are then left to the views
    if (!still && event->key() == Qt::Key_Left) return moveBy({keyPan_px, 0});
    if (!still && event->key() == Qt::Key_Right) return moveBy({-keyPan_px, 0});
    if (!still && event->key() == Qt::Key_Up) return moveBy({0, keyPan_px});
    if (!still && event->key() == Qt::Key_Down) return moveBy({0, -keyPan_px});
    QWidget::keyPressEvent(event);
}

void SheetView::resizeEvent(QResizeEvent* event)
{
    closeField();
    QWidget::resizeEvent(event);
    update();
}

}  // namespace lathelier::drawing_panel
