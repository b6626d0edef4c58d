// How a PlotCanvas leaves the program: clipboard, SVG, PDF, PNG, CSV.
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QMenu>
#include <QSaveFile>
#include <QSvgGenerator>

#include "widgets/plot/plot_parts.h"

namespace lathelier {

void PlotCanvas::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    fillMenu(menu);
    menu.exec(event->globalPos());
}

void PlotCanvas::fillMenu(QMenu& menu)
{
    menu.addAction(tr("Copy picture"), this, [this] { QApplication::clipboard()->setImage(picture()); });
    menu.addAction(tr("Save picture…"), this, &PlotCanvas::askAndSavePicture);
    menu.addAction(tr("Save data as CSV…"), this, &PlotCanvas::askAndSaveData);
    menu.addSeparator();
    menu.addAction(tr("Show all"), this, &PlotCanvas::resetView);
}

void PlotCanvas::askAndSavePicture()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Save picture"), accessibleName() + ".svg",
                                                      tr("Scalable picture (*.svg);;PDF (*.pdf);;Picture (*.png)"));
    if (!path.isEmpty() && !savePicture(path)) emit notWritten(path);
}

void PlotCanvas::askAndSaveData()
{
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save data"), accessibleName() + ".csv", tr("Table (*.csv)"));
    if (!path.isEmpty() && !saveData(path)) emit notWritten(path);
}

QImage PlotCanvas::picture(double scale)
{
    hideCrosshair();
    restyle(paperPalette());
    const QImage image = plot_->toPixmap(width(), height(), scale).toImage();
    restyle(palette());
    redraw();
    return image;
}

bool PlotCanvas::savePicture(const QString& path)
{
    if (path.endsWith(".png", Qt::CaseInsensitive)) return picture().save(path);
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

bool PlotCanvas::saveData(const QString& path) const
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.write(csv().toUtf8());
    return file.commit();
}

}  // namespace lathelier
