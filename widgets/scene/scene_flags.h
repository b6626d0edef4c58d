// Flags over the 3-D image: values at places of the part, each joined with its place by a line.
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/scene/scene_camera.h"

namespace lathelier::scene {

/// Labels above their places, none over another. Mouse events go through.
class SceneFlags : public QWidget {
    Q_OBJECT

public:
    explicit SceneFlags(QWidget* parent = nullptr);
    void setFlags(std::vector<SceneFlag> flags);
    const std::vector<SceneFlag>& flags() const { return flags_; }
    void setCamera(const SceneCamera& camera);

    /// Labels as drawn, in the order of the flags; empty for a place behind the eye or outside the picture.
    std::vector<QRectF> labels() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<QPointF> pixelOf(const SceneFlag& flag) const;

    std::vector<SceneFlag> flags_;
    SceneCamera camera_;
};

}  // namespace lathelier::scene
