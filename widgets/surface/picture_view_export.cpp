// A PictureView as picture, vector file and CSV.
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "widgets/plot/plot_style.h"
#include "widgets/surface/picture_view.h"

namespace lathelier::surface_panel {

QImage PictureView::picture(double scale)
{
    QImage sheet(size() * scale, QImage::Format_RGB32);
    sheet.setDevicePixelRatio(scale);
    QPainter painter(&sheet);
    pointer_.reset();
    paint(painter, plot::paperPalette());
    return sheet;
}

bool PictureView::saveVector(const QString& path)
{
    pointer_.reset();
    const auto paintOn = [&](QPaintDevice& device, double scale) {
        QPainter painter;
        if (!painter.begin(&device)) return false;
        painter.scale(scale, scale);
        paint(painter, plot::paperPalette());
        return painter.end();
    };
    if (path.endsWith(".pdf", Qt::CaseInsensitive)) {
        QPdfWriter writer(path);
        writer.setTitle(accessibleName());
        writer.setPageSize(QPageSize(QSizeF(width(), height()) * 0.75, QPageSize::Point));
        writer.setPageMargins({});
        return paintOn(writer, writer.width() / static_cast<double>(width()));
    }
    QSvgGenerator generator;
    generator.setFileName(path);
    generator.setTitle(accessibleName());
    generator.setSize(size());
    generator.setViewBox(rect());
    return paintOn(generator, 1);
}

QString PictureView::csv() const
{
    QString text = QStringLiteral("lines,x1_px,y1_px,x2_px,y2_px\n");
    for (const Overlay& overlay : overlays_)
        for (const auto& [a, b] : overlay.stripes)
            text += QStringLiteral("\"%1\",%2,%3,%4,%5\n")
                        .arg(QString(overlay.name).replace('"', QStringLiteral("\"\"")))
                        .arg(a.x)
                        .arg(a.y)
                        .arg(b.x)
                        .arg(b.y);
    return text;
}

}  // namespace lathelier::surface_panel
