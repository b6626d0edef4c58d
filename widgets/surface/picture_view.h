// A grey picture that can be zoomed and panned, with stripes, rulers and a scale bar drawn over it, and tools that
// choose something in it: a region, a length, a direction. Plot coordinates are pixels of the picture.
#pragma once

#include <QImage>
#include <QPointF>
#include <QRectF>
#include <optional>
#include <vector>

#include "engine/report/colours.h"
#include "engine/surface/stripes.h"
#include "widgets/plot/plot_widget.h"
#include "widgets/surface/picture_pyramid.h"

class QPainter;

namespace lathelier::surface_panel {

/// Lines over the picture.
struct Overlay {
    QString name;                          ///< for the legend
    report::ChartColour colour;            ///< colour role
    std::vector<surface::Stripe> stripes;  ///< in pixels of the picture
    double spacing_px = 0;                 ///< line spacing; drawn only where lines are resolved
    double width = 1;                      ///< in widths of a line
};

/// Marks a pitch apart along an edge of the picture.
struct Ruler {
    QString name;                ///< "marks found 0.1999 mm"
    report::ChartColour colour;  ///< as an Overlay's
    double pitch_px = 0;         ///< of the marks, along their direction
};

class PictureView : public plot::PlotWidget {
    Q_OBJECT

public:
    enum class Tool { None, Region, Length, Direction, Point };

    explicit PictureView(QWidget* parent = nullptr);

    /// A picture of another size is shown whole. `mm_per_px` 0: not known.
    void setPicture(const QImage& image, double mm_per_px);
    /// In the slider's view: this one takes the place of the picture right of `share` of its width; null: none.
    void setSecond(const QImage& image, double share);
    void setOverlays(std::vector<Overlay> overlays);
    void setRulers(std::vector<Ruler> rulers, double direction_deg);  ///< across the marks, from right toward down
    void setRegion(const std::optional<QRectF>& region);
    void setArrow(const std::optional<double>& direction_deg);

    Tool tool() const { return tool_; }
    void setTool(Tool tool);

    /// A part of the picture several times as large about the pointer, in linked views about the same place.
    void setMagnifier(bool on);
    bool hasMagnifier() const { return magnifier_; }
    const std::optional<QPointF>& lens() const { return lens_; }  ///< its place, in pixels of the picture

    const QImage& image() const { return picture_.whole(); }
    const std::vector<Overlay>& overlays() const { return overlays_; }
    QPointF placeOf(const QPointF& pixel) const;  ///< in this widget
    QPointF pixelAt(const QPointF& place) const;  ///< of the picture
    double zoom() const;                          ///< of the widget's pixels per pixel of the picture

    /// Zoom and place are the same in both, whichever of them is moved. `other` must live as long.
    void link(PictureView* other);

    QImage picture(double scale = 2) override;
    void resetView() override;
    QString csv() const override;

    QSize sizeHint() const override { return {480, 320}; }
    QSize minimumSizeHint() const override { return {140, 100}; }

signals:
    void regionDrawn(const QRectF& region);
    void lengthDrawn(double pixels);
    void directionDrawn(double direction_deg);
    void pointChosen(const QPointF& pixel);
    void viewMoved();

protected:
    bool saveVector(const QString& path) override;
    void sizeChosen() override { update(); }
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void paint(QPainter& painter, const QPalette& palette) const;
    void paintPicture(QPainter& painter) const;
    void paintOverlays(QPainter& painter, const QPalette& palette) const;
    void paintRulers(QPainter& painter, const QPalette& palette) const;
    void paintTools(QPainter& painter, const QPalette& palette) const;
    void paintScaleBar(QPainter& painter, const QPalette& palette) const;
    void paintLens(QPainter& painter, const QPalette& palette) const;
    void paintWords(QPainter& painter, const QPalette& palette) const;
    QString placeWords(const QPointF& at) const;
    QString lengthWords() const;
    void showLens(const std::optional<QPointF>& pixel);
    bool moveLens(int key);
    double fitting() const;
    void zoomAt(const QPointF& place, double factor);
    void panBy(const QPointF& by);
    void showPart(double zoom, const QPointF& middle);
    void updateLinkedViews();

    PicturePyramid picture_;
    PicturePyramid second_;
    double share_ = 1;
    double mm_per_px_ = 0;
    std::vector<Overlay> overlays_;
    std::vector<Ruler> rulers_;
    double rulersDirection_deg_ = 0;
    std::optional<QRectF> region_;
    std::optional<double> arrow_deg_;
    Tool tool_ = Tool::None;
    double zoom_ = 0;                 ///< 0: the whole picture
    QPointF middle_;                  ///< centre of the view, in pixels of the picture
    std::optional<QPointF> pressed_;  ///< where a drag began, in the widget
    std::optional<QPointF> pointer_;  ///< in the widget
    std::vector<QPointF> chosen_;     ///< ends of a length, or a point, in pixels of the picture
    bool magnifier_ = false;
    std::optional<QPointF> lens_;
    std::vector<PictureView*> linked_;
};

}  // namespace lathelier::surface_panel
