// Before and after: side by side, or one under a slider; zoom and pan are linked.
#pragma once

#include <QButtonGroup>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "widgets/surface/picture_view.h"

namespace lathelier::surface_panel {

class ComparisonView : public QWidget {
    Q_OBJECT

public:
    explicit ComparisonView(QWidget* parent = nullptr);

    void setPictures(const QImage& before, const QImage& after, double mm_per_px);
    void setNames(const QString& before, const QString& after, const QString& alignment);

    bool hasSlider() const { return slides_; }
    void setSlides(bool slides);  ///< one picture with a slider; else side by side
    double share() const { return share_; }
    void setShare(double share);  ///< of the width, that shows the first picture
    PictureView* before() const { return before_; }
    PictureView* after() const { return after_; }
    QSlider* slider() const { return slider_; }
    void retranslate();

signals:
    void notWritten(const QString& path);
    void layRequested(const QPointF& further_px);  ///< request to shift the second picture by this offset

private:
    void arrange();
    void lay(bool on);
    void takePoint(bool first, const QPointF& pixel);

    PictureView* before_;
    PictureView* after_;
    QWidget* beforeSide_;
    QWidget* afterSide_;
    QLabel* beforeName_;
    QLabel* afterName_;
    QLabel* alignment_;
    QSlider* slider_;
    QToolButton* magnifier_;
    QToolButton* lay_;
    QButtonGroup* ways_;
    QImage first_, second_;
    double mm_per_px_ = 0;
    double share_ = 0.5;
    bool slides_ = false;
    std::optional<QPointF> placeBefore_, placeAfter_;  ///< one place in both, while it is being clicked
};

}  // namespace lathelier::surface_panel
