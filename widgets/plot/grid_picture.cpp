#include "widgets/plot/grid_picture.h"

#include <cmath>

namespace lathelier::plot {

void GridPicture::set(const report::ColourMap& map, const report::DeviationColours& colours)
{
    image_ = {};
    if (map.empty()) return;
    QImage image(map.columns, map.rows, QImage::Format_ARGB32_Premultiplied);
    for (int row = 0; row < map.rows; ++row) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(map.rows - 1 - row));
        for (int column = 0; column < map.columns; ++column) {
            const float value = map.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                                           static_cast<std::size_t>(column)];
            const report::Rgb c = colours(static_cast<double>(value));
            line[column] = std::isnan(value) ? 0 : qRgb(c.red, c.green, c.blue);
        }
    }
    image_ = std::move(image);
    place_ = QRectF(map.x_from, map.y_from, map.x_to - map.x_from, map.y_to - map.y_from);
}

void GridPicture::draw(QCPPainter* painter)
{
    if (image_.isNull()) return;
    const QPointF low = coordsToPixels(place_.left(), place_.top());
    const QPointF high = coordsToPixels(place_.right(), place_.bottom());
    painter->setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter->setOpacity(opacity_);
    painter->drawImage(QRectF(QPointF(low.x(), high.y()), QPointF(high.x(), low.y())), image_);
    painter->setOpacity(1);
}

}  // namespace lathelier::plot
