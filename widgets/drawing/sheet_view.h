// A sheet of paper with a drawing on it: fitted to the view, enlarged with the wheel, moved by dragging. Rows and
// dimensions can be clicked; a double click on a dimension opens a field over it.
#pragma once

#include <QLineEdit>
#include <QPolygonF>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "engine/drawing/drawing.h"

class QSvgRenderer;
class QPainter;

namespace lathelier::drawing_panel {

class SheetView : public QWidget {
    Q_OBJECT

public:
    explicit SheetView(QWidget* parent = nullptr);
    ~SheetView() override;

    /// A new sheet is fitted to the view.
    void setDrawing(const drawing::Drawing& drawing);
    double zoom() const { return zoom_; }  ///< zoom factor; 1: the whole sheet
    QRectF sheetRect() const;              ///< rectangle of the sheet in pixels
    void fit();

    /// Contours of the rows of the outside, (z, r) in mm of the part.
    void setRows(std::vector<QPolygonF> contours);
    /// Highlights a row with its dimensions.
    void markRow(std::optional<std::size_t> row);
    /// Position in this view of a place of the part, or of a text of the drawing.
    QPointF pixelOf(double z_mm, double radius_mm) const;
    QRectF pixelsOf(const drawing::Label& label) const;
    /// Opens the field over a dimension, with `text` in it.
    void editDimension(std::size_t label, const QString& text, const QString& help);
    QLineEdit* field() const { return field_; }

    QSize sizeHint() const override { return {640, 450}; }

signals:
    void rowClicked(int row);                                        ///< clicked row; -1: outside the part
    void menuRequested(int row, double z_mm, const QPoint& global);  ///< menu of the row under the pointer or of the
                                                                     ///< highlighted one
    void dimensionActivated(int label);                              ///< label: index into Drawing::labels
    void dimensionTyped(int label, const QString& text);             ///< text of the editor
    void rowKeyPressed(QKeyEvent* event);                            ///< accepted by the handler

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool event(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void zoomBy(double factor, const QPointF& about);
    void moveBy(const QPointF& by);
    QPointF partOf(const QPointF& pixel) const;
    std::optional<std::size_t> rowAt(const QPointF& pixel) const;
    std::optional<std::size_t> dimensionAt(const QPointF& pixel) const;
    void paintMark(QPainter& painter) const;
    void closeField();

    drawing::Drawing drawing_;
    std::vector<QPolygonF> rows_;
    std::optional<std::size_t> row_;
    QLineEdit* field_;
    int fieldOf_ = -1;  ///< label being edited, index into Drawing::labels
    std::unique_ptr<QSvgRenderer> svg_;
    QSizeF paper_mm_;  ///< sheet size; empty: no drawing yet
    double zoom_ = 1;
    QPointF middle_{0.5, 0.5};  ///< centre of the view relative to the sheet size
    QPointF dragged_;           ///< last pointer position
    QPointF pressed_;           ///< pointer position at the button press
    bool moved_ = false;        ///< moved since the button press
};

}  // namespace lathelier::drawing_panel
