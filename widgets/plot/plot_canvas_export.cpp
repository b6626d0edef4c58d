// Export of a PlotCanvas as image and vector file.
#include <QSvgGenerator>

#include "widgets/plot/plot_parts.h"

namespace lathelier::plot {

QImage PlotCanvas::picture(double scale)
{
    hideCrosshair();
    restyle(paperPalette());
    QImage image = plot_->toPixmap(width(), height(), scale).toImage();
    restyle(palette());
    redraw();
    return image;
}

bool PlotCanvas::saveVector(const QString& path)
{
    hideCrosshair();
    restyle(paperPalette());
    bool done = false;
    if (path.endsWith(".pdf", Qt::CaseInsensitive)) {
        done = plot_->savePdf(path, width(), height(), QCP::epAllowCosmetic, {}, accessibleName());
    } else {
        QSvgGenerator generator;
        generator.setFileName(path);
        generator.setTitle(accessibleName());
        generator.setSize(size());
        generator.setViewBox(rect());
        QCPPainter painter;
        done = painter.begin(&generator);
        if (done) {
            painter.setMode(QCPPainter::pmVectorized);
            plot_->toPainter(&painter, width(), height());
            done = painter.end();
        }
    }
    restyle(palette());
    redraw();
    return done;
}

}  // namespace lathelier::plot
