// The polar plot of roundness: closed profiles around a base circle at a stated magnification, reference circles,
// contact points, one marked angle. Painted by PolarPainter, since no plot library magnifies deviations.
#pragma once

#include <QPixmap>

#include "widgets/plot/plot_style.h"
#include "widgets/plot/plot_widget.h"
#include "widgets/plot/pointer_tag.h"
#include "widgets/plot/polar_data.h"

namespace lathelier::plot {

/// The wheel (or + and -) changes the magnification, a double click (or Home) fits it again; ← and → move the mark from
/// sample to sample of the first trace, Escape or the menu removes it.
class PolarView : public PlotWidget {
    Q_OBJECT

public:
    explicit PolarView(QWidget* parent = nullptr);

    /// Shows `picture`; the user's magnification stays when the title is the same as before.
    void setPicture(const PolarPicturePtr& picture);
    const PolarPicturePtr& polar() const { return picture_; }

    /// Stated magnification: drawn deviation over drawn radius.
    double magnification() const;
    void setMagnification(std::optional<double> magnification);  ///< none: automatic

    /// Also draws the optional circles with this key; empty: none of them.
    void setAsked(const std::string& key);

    /// Marks one angle, set here or by a linked view.
    void setMarker(std::optional<double> angle_deg);
    std::optional<double> marker() const { return marker_; }

    /// Angle and deviation under the pointer, else of the marker; empty when there is neither.
    QString readout() const;

    /// Position of a sample in this widget, for tests and callouts.
    QPointF pixelAt(double angle_deg, double deviation_um) const;
    QRectF discRect() const;  ///< area inside the rim
    /// Tag with the deviation at the pointer's angle.
    const PointerTag& tag() const { return *tag_; }

    QImage picture(double scale = 2) override;
    QString csv() const override;
    void resetView() override { setMagnification({}); }

    QSize sizeHint() const override { return {480, 480}; }
    QSize minimumSizeHint() const override { return {180, 180}; }

signals:
    void clicked(double angle_deg);  ///< clicked, or moved by keyboard
    void unmarked();                 ///< the user removed the mark
    void pointed(double angle_deg);  ///< the pointer is over this angle
    void pointerLeft();
    void magnificationChanged(double magnification);

protected:
    bool saveVector(const QString& path) override;
    void addToMenu(QMenu& menu) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void forgetPixmap();
    void point(std::optional<double> angle_deg);
    void step(int samples);
    void choose(std::optional<double> angle_deg);
    QString angleReadout(double angle_deg) const;

    PointerTag* tag_;
    PolarPicturePtr picture_;
    std::string asked_;              ///< key of the requested circles
    std::optional<double> chosen_;   ///< magnification chosen by the user; none: automatic
    std::optional<double> marker_;   ///< marked angle in degrees
    std::optional<double> pointer_;  ///< pointer angle in degrees
    std::optional<double> before_;   ///< marker before the last press, restored by a double click
    bool pressed_ = false;
    QPixmap pixmap_;  ///< cached static part of the drawing
    int wheel_ = 0;
};

}  // namespace lathelier::plot
