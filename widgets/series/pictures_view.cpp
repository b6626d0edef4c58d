#include "widgets/series/pictures_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "widgets/core/language.h"
#include "widgets/plot/plot_style.h"

namespace lathelier::series_panel {
namespace {

constexpr double gap = 6;                // px between pictures
constexpr double preferredAspect = 1.4;  // of a picture with its caption
constexpr int legendWidthLeast = 240;    // px of the widget from which on the scale is drawn

QImage imageOf(const report::ColourMap& map)
{
    QImage image(map.columns, map.rows, QImage::Format_ARGB32);
    const report::DeviationColours colours = report::coloursOf(map);
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column) {
            const float value = map.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                                           static_cast<std::size_t>(column)];
            image.setPixelColor(
                column, map.rows - 1 - row,
                std::isnan(value) ? QColor(Qt::transparent) : plot::toQt(colours(static_cast<double>(value))));
        }
    return image;
}

}  // namespace

PicturesView::PicturesView(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
}

void PicturesView::setPictures(const std::vector<series::SmallPicture>& pictures, const std::string& chosen)
{
    tiles_.clear();
    tiles_.reserve(pictures.size());
    for (const series::SmallPicture& picture : pictures) tiles_.push_back({picture, imageOf(picture.map)});
    chosen_ = chosen;
    update();
}

plot::Legend PicturesView::legend() const
{
    const report::ColourMap& map = tiles_.front().picture.map;
    return {report::coloursOf(map), {}, plot::chartText(report::Axis{map.value.title, map.value.unit}), map.value.unit};
}

/// In pixels; 0: there is no room for the scale.
double PicturesView::legendWidth() const
{
    if (tiles_.empty() || width() < legendWidthLeast) return 0;
    const plot::Legend shown = legend();
    return std::max(plot::colourLegendWidth(shown, font(), QLocale()), fontMetrics().horizontalAdvance(shown.title));
}

QRectF PicturesView::roomOfTiles() const
{
    const double beside = legendWidth();
    return QRectF(rect()).adjusted(gap, gap, -gap - (beside > 0 ? beside + gap : 0), -gap);
}

/// The number of columns whose pictures come nearest to the preferred shape.
PicturesView::Grid PicturesView::grid() const
{
    const QRectF room = roomOfTiles();
    const int count = std::max<int>(1, static_cast<int>(tiles_.size()));
    Grid best;
    double least = HUGE_VAL;
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const QSizeF tile(room.width() / columns, room.height() / rows);
        if (!(tile.width() > 0) || !(tile.height() > 0)) continue;
        const double misfit = std::abs(std::log(tile.width() / tile.height() / preferredAspect));
        if (misfit < least) {
            least = misfit;
            best = {columns, rows, tile};
        }
    }
    return best;
}

QRectF PicturesView::placeOf(std::size_t tile) const
{
    const Grid cells = grid();
    const auto columns = static_cast<std::size_t>(cells.columns);
    const std::size_t row = tile / columns, column = tile % columns;
    const QPointF corner(static_cast<double>(column) * cells.tile.width(),
                         static_cast<double>(row) * cells.tile.height());
    return {roomOfTiles().topLeft() + corner, cells.tile};
}

int PicturesView::tileAt(const QPointF& place) const
{
    for (std::size_t i = 0; i < tiles_.size(); ++i)
        if (placeOf(i).contains(place)) return static_cast<int>(i);
    return -1;
}

void PicturesView::paintTile(QPainter& painter, const QRectF& room, const Tile& tile) const
{
    const double line = fontMetrics().height();
    const QRectF inner = room.adjusted(gap / 2, gap / 2, -gap / 2, -gap / 2);
    const bool has_caption = inner.height() > 3 * line;
    const QRectF picture = has_caption ? inner.adjusted(0, 0, 0, -line) : inner;
    painter.drawImage(picture, tile.image);
    const bool is_out = tile.picture.verdict == Verdict::Fail;
    const plot::PlotStyle style(palette(), font());
    painter.setPen(is_out ? QPen(style.colour(report::ColourRole::Excess), 2) : QPen(style.grid, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(picture);
    if (tile.picture.uuid == chosen_) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 3));
        painter.drawRect(inner.adjusted(-1, -1, 1, 1));
    }
    if (!has_caption) return;
    QString words = QString::fromStdString(tile.picture.file);
    if (tile.picture.verdict)
        words.prepend(*tile.picture.verdict == Verdict::Pass ? QStringLiteral("✓ ")
                      : is_out                               ? QStringLiteral("✗ ")
                                                             : QStringLiteral("? "));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(inner.left(), picture.bottom(), inner.width(), line), Qt::AlignCenter,
                     fontMetrics().elidedText(words, Qt::ElideMiddle, static_cast<int>(inner.width())));
}

void PicturesView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);  // a cell is a mean, and is drawn as one
    for (std::size_t i = 0; i < tiles_.size(); ++i) paintTile(painter, placeOf(i), tiles_[i]);
    const double beside = legendWidth();
    if (!(beside > 0)) return;
    const QRectF tiles = roomOfTiles();
    plot::paintColourLegend(painter, {tiles.right() + gap, tiles.top(), beside, tiles.height()}, legend(), font(),
                            palette().color(QPalette::WindowText), QLocale());
}

void PicturesView::choose(int tile)
{
    if (tile < 0 || tile >= static_cast<int>(tiles_.size())) return;
    chosen_ = tiles_[static_cast<std::size_t>(tile)].picture.uuid;
    update();
    emit partChosen(chosen_);
}

void PicturesView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) choose(tileAt(event->localPos()));
}

void PicturesView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (const int tile = tileAt(event->localPos()); tile >= 0)
        emit partOpened(tiles_[static_cast<std::size_t>(tile)].picture.uuid);
}

void PicturesView::keyPressEvent(QKeyEvent* event)
{
    int at = 0;
    for (std::size_t i = 0; i < tiles_.size(); ++i)
        if (tiles_[i].picture.uuid == chosen_) at = static_cast<int>(i);
    switch (event->key()) {
        case Qt::Key_Left: return choose(at - 1);
        case Qt::Key_Right: return choose(at + 1);
        case Qt::Key_Up: return choose(at - grid().columns);
        case Qt::Key_Down: return choose(at + grid().columns);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (!tiles_.empty()) emit partOpened(tiles_[static_cast<std::size_t>(at)].picture.uuid);
            return;
        default: QWidget::keyPressEvent(event);
    }
}

bool PicturesView::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int tile = tileAt(help->pos());
        if (tile >= 0)
            QToolTip::showText(help->globalPos(),
                               QString::fromStdString(tiles_[static_cast<std::size_t>(tile)].picture.file), this);
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

}  // namespace lathelier::series_panel
