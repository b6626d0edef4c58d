#include "widgets/plot/plot_widget.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QVariant>

#include "engine/core/error.h"
#include "engine/io/file.h"
#include "widgets/core/panel/view_frame.h"

namespace lathelier::plot {
namespace {

/// Atomic writing.
bool write(const QString& path, const QByteArray& bytes)
{
    try {
        io::writeFile(path.toStdString(), std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

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

PlotWidget::PlotWidget(QWidget* parent) : QWidget(parent)
{
    setProperty(ViewFrame::smallView, false);
}

bool PlotWidget::isSmall() const
{
    return property(ViewFrame::smallView).toBool();
}

bool PlotWidget::event(QEvent* event)
{
    if (event->type() == QEvent::DynamicPropertyChange &&
        static_cast<QDynamicPropertyChangeEvent*>(event)->propertyName() == ViewFrame::smallView)
        sizeChosen();
    return QWidget::event(event);
}

bool PlotWidget::savePicture(const QString& path)
{
    QByteArray bytes;
    if (path.endsWith(".png", Qt::CaseInsensitive)) {
        QBuffer buffer(&bytes);
        if (!buffer.open(QIODevice::WriteOnly) || !picture().save(&buffer, "PNG")) return false;
    } else {
        try {
            const io::PartFolder aside;
            QFile file(QFile::decodeName(aside.path().c_str()) + "/plot." + QFileInfo(path).suffix());
            if (!saveVector(file.fileName()) || !file.open(QIODevice::ReadOnly)) return false;
            bytes = file.readAll();
        } catch (const Error&) {
            return false;
        }
    }
    return write(path, bytes);
}

bool PlotWidget::saveData(const QString& path) const
{
    return write(path, csv().toUtf8());
}

}  // namespace lathelier::plot
