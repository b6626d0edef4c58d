// What a PictureView draws over its picture.
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QPen>
#include <QPointF>
#include <QRect>
#include <QStringList>
#include <vector>

class QPainter;

namespace lathelier::plot {
struct PlotStyle;
}

namespace lathelier::surface_panel {

class PictureView;
struct Overlay;
struct Ruler;

/// Lines that stand closer on the screen are not drawn.
inline constexpr double closestStripes = 4;

void drawStripes(QPainter& painter, const Overlay& overlay, const plot::PlotStyle& style, double zoom,
                 const PictureView& view);

/// Along the lower edge where the marks stand upright, along the left one where they lie.
void drawRulers(QPainter& painter, const std::vector<Ruler>& rulers, double direction_deg, double zoom,
                const QRect& room, const QPalette& palette, const QFont& font);

/// What lies outside is shaded.
void drawRegion(QPainter& painter, const QRectF& region, const QRect& room, const QPen& pen);
void drawArrow(QPainter& painter, const QPointF& from, const QPointF& to, const QPen& pen);

/// A line with its ends; one end alone: a cross.
void drawLength(QPainter& painter, const std::vector<QPointF>& ends, const QPen& pen);

/// A round length in the lower right corner.
void drawScaleBar(QPainter& painter, double mm_per_pixel, const QRect& room, const QPalette& palette,
                  const QFont& font);

/// Lines of words in the upper left corner, each with its colour; an invalid one: words alone.
void drawLegend(QPainter& painter, const QStringList& lines, const std::vector<QColor>& colours,
                const QPalette& palette, const QFont& font);

}  // namespace lathelier::surface_panel
