// A sheet of paper with a drawing on it: fitted to the view, enlarged with the wheel, moved by dragging.
#pragma once

#include <QWidget>
#include <memory>

#include "engine/drawing/drawing.h"

class QSvgRenderer;

namespace lathelier::drawing_panel {

class SheetView : public QWidget {
    Q_OBJECT

public:
    explicit SheetView(QWidget* parent = nullptr);
    ~SheetView() override;

    /// Another sheet is fitted again.
    void setDrawing(const drawing::Drawing& drawing);
    double zoom() const { return zoom_; }  ///< 1: the whole sheet
    QRectF sheetRect() const;              ///< where it lies, in pixels
    void fit();

    QSize sizeHint() const override { return {640, 450}; }

protected:
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

    std::unique_ptr<QSvgRenderer> svg_;
    QSizeF paper_mm_;  ///< empty: nothing is drawn yet
    double zoom_ = 1;
    QPointF middle_{0.5, 0.5};  ///< of the view, in parts of the sheet
    QPointF dragged_;           ///< last place of the pointer
};

}  // namespace lathelier::drawing_panel
