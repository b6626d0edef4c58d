// Interface of a plot for context menu and exports: image, vector file, data as CSV, "show all".
#pragma once

#include <QImage>
#include <QWidget>

class QMenu;

namespace lathelier::plot {

class PlotWidget : public QWidget {
    Q_OBJECT

public:
    /// The plot as shown, dark on white.
    virtual QImage picture(double scale = 2) = 0;

    /// Writes .svg, .pdf or .png by the extension, dark on white; false when the file cannot be written.
    bool savePicture(const QString& path);

    /// Writes the data as CSV in UTF-8; false when the file cannot be written.
    bool saveData(const QString& path) const;
    virtual QString csv() const = 0;

    /// Shows the whole of the data again.
    virtual void resetView() = 0;

signals:
    void notWritten(const QString& path);  ///< the file could not be written

protected:
    explicit PlotWidget(QWidget* parent);

    /// The plot is a small view beside the large one (ViewFrame::smallView): titles, legend and fields are omitted in
    /// favour of the data.
    bool isSmall() const;
    virtual void sizeChosen() {}  ///< isSmall() has changed
    bool event(QEvent* event) override;
    virtual bool saveVector(const QString& path) = 0;  ///< saves .svg or .pdf
    virtual void addToMenu(QMenu&) {}                  ///< further menu entries of a kind of plot

    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void askAndSavePicture();
    void askAndSaveData();
};

}  // namespace lathelier::plot
