// Widgets over the 3-D image: directions of the axes, a length scale, the label of a picked point.
#pragma once

#include <QLabel>
#include <QWidget>

#include "widgets/scene/scene_camera.h"

namespace lathelier::scene {

/// x, y, z as seen by the camera, and a bar of a round length.
class SceneRuler : public QWidget {
    Q_OBJECT

public:
    explicit SceneRuler(QWidget* parent = nullptr);
    void setCamera(const SceneCamera& camera, int pictureHeight_px);
    QSize sizeHint() const override;
    /// The length the bar stands for; 1, 2 or 5 × 10^n.
    double length_mm() const { return length_mm_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    SceneCamera camera_;
    double length_mm_ = 1;
    double length_px_ = 0;
};

/// Text on a light background that forwards mouse events.
class SceneLabel : public QLabel {
    Q_OBJECT

public:
    explicit SceneLabel(QWidget* parent = nullptr);
};

}  // namespace lathelier::scene
