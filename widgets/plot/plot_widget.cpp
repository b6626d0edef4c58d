#include "widgets/plot/plot_widget.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QMenu>
#include <QSaveFile>

namespace lathelier {

void PlotWidget::contextMenuEvent(QContextMenuEvent* event)
{
    QMenu menu(this);
    menu.addAction(tr("Copy picture"), this, [this] { QApplication::clipboard()->setImage(picture()); });
    menu.addAction(tr("Save picture…"), this, &PlotWidget::askAndSavePicture);
    menu.addAction(tr("Save data as CSV…"), this, &PlotWidget::askAndSaveData);
    menu.addSeparator();
    menu.addAction(tr("Show all"), this, &PlotWidget::resetView);
    addToMenu(menu);
    menu.exec(event->globalPos());
}

void PlotWidget::askAndSavePicture()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Save picture"), accessibleName() + ".svg",
                                                      tr("Scalable picture (*.svg);;PDF (*.pdf);;Picture (*.png)"));
    if (!path.isEmpty() && !savePicture(path)) emit notWritten(path);
}

void PlotWidget::askAndSaveData()
{
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save data"), accessibleName() + ".csv", tr("Table (*.csv)"));
    if (!path.isEmpty() && !saveData(path)) emit notWritten(path);
}

bool PlotWidget::savePicture(const QString& path)
{
    if (path.endsWith(".png", Qt::CaseInsensitive)) return picture().save(path);
    return saveVector(path);
}

bool PlotWidget::saveData(const QString& path) const
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.write(csv().toUtf8());
    return file.commit();
}

}  // namespace lathelier
