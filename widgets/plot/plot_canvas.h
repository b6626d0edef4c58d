// Common base of plots: title, crosshair with a readout in place of the title (its remark stays), wheel zoom, drag to
// pan, double click to reset, keyboard, context menu with copy and save. ChartView and MapView add the content.
#pragma once

#include <memory>
#include <optional>

#include "widgets/plot/plot_style.h"
#include "widgets/plot/plot_widget.h"
#include "widgets/plot/pointer_tag.h"

class QCustomPlot;

namespace lathelier::plot {

class PlotCanvas : public PlotWidget {
    Q_OBJECT

public:
    ~PlotCanvas() override;

    QImage picture(double scale = 2) override;
    void resetView() override;
    /// The visible ranges: x from the left, width, y from below, height.
    QRectF visibleRange() const;
    /// Position of a data point in this widget, for tests and callouts.
    QPointF pixelAt(double x, double y) const;
    /// Readout shown in place of the title while the pointer is over the axes.
    QString readout() const;
    /// While `on`, a drag selects an interval of the x axis instead of panning.
    void setDrawsStretch(bool on);
    /// Tag with the value nearest to the pointer.
    const PointerTag& tag() const { return *tag_; }

    QSize sizeHint() const override { return {480, 320}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    void clicked(double x, double y);           ///< a click that was no drag, in data coordinates
    void stretchDrawn(double from, double to);  ///< on the x axis, from < to
    void clickTakenBack();                      ///< the last click was the first half of a double click

protected:
    explicit PlotCanvas(QWidget* parent);

    QCustomPlot& plot() const { return *plot_; }
    const PlotStyle& style() const { return style_; }
    void setTitles(const QString& title, const QString& remark, const QString& x, const QString& y);
    void setAxes(const report::Axis& x, const report::Axis& y);  ///< scales, and units of the numbers
    void setReadout(const QString& text);
    void showLegend(bool shown);
    void leaveRoomInTitle(int pixels);  ///< space reserved at its right end
    /// Redraws; `keepView` leaves the ranges when the user has chosen them.
    void refresh(bool keepView);
    void redraw();  ///< deferred redraw, if visible
    void drawOverlay();
    bool isViewChosen() const;  ///< the user has zoomed or panned
    void chooseView();          ///< marks the view as chosen by the user

    virtual void applyStyle() = 0;                            ///< applies colours, widths and fonts to the content
    virtual QString readoutAt(double x, double y) const = 0;  ///< text of the crosshair readout
    virtual PointerTag::Words tagAt(const QPointF& pointer, double x, double y) const = 0;  ///< pointer in px
    virtual void fitRanges() = 0;                             ///< sets the ranges to all data
    virtual int besideAxes() const { return 0; }              ///< px at the right not used by the axes
    virtual bool beginDrag(const QPointF&) { return false; }  ///< true: the content handles the drag
    virtual void continueDrag(double, double) {}
    virtual void endDrag() {}
    virtual bool isHandle(const QPointF&, Qt::CursorShape&) const { return false; }

    void sizeChosen() override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool saveVector(const QString& path) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Parts;
    void restyle(const QPalette& palette);
    void fitTexts();
    void placeLegend();
    void mousePressed(QMouseEvent* event);
    void mouseMoved(QMouseEvent* event);
    void mouseReleased(QMouseEvent* event);
    void mouseDoubleClicked(QMouseEvent* event);
    void mouseWheel(QWheelEvent* event);
    void hideCrosshair();

    QCustomPlot* plot_;
    PointerTag* tag_;
    PlotStyle style_;
    std::unique_ptr<Parts> parts_;
};

}  // namespace lathelier::plot
