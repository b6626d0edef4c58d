// The row of buttons above the 3-D picture: viewpoints, projection, section.
#pragma once

#include <QWidget>

#include "widgets/scene/scene_data.h"

class QAbstractButton;
class QComboBox;
class QSlider;

namespace lathelier::scene {

class SceneBar : public QWidget {
    Q_OBJECT

public:
    explicit SceneBar(QWidget* parent = nullptr);

signals:
    void viewpointRequested(lathelier::scene::SceneViewpoint viewpoint);
    void parallelRequested(bool parallel);
    void sectionRequested(int sceneAxis, double share);  ///< sceneAxis -1: whole

protected:
    void changeEvent(QEvent* event) override;

private:
    void setTexts();

    std::vector<QAbstractButton*> viewpoints_;
    QAbstractButton* parallel_;
    QComboBox* section_;
    QSlider* slider_;
};

}  // namespace lathelier::scene
