// The views of a record: trajectories of axis and tool, error motion, coordinates, signals, all sections in 3-D, and
// what was understood of the record. One angle is marked in all of them.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QTabWidget>
#include <QWidget>

#include "widgets/plot/chart_view.h"
#include "widgets/plot/polar_view.h"
#include "widgets/trajectory_common/section_bar.h"

namespace lathelier {

class ChannelTable;
class SceneView;

class TrajectoryViews : public QWidget {
    Q_OBJECT

public:
    explicit TrajectoryViews(MarkedAngle& angle, QWidget* parent = nullptr);

    /// `channels`: the map in force.
    void setPicture(const std::shared_ptr<const SpindlePicture>& picture, bool sectionChosen,
                    const std::string& channels);
    void retranslate();

signals:
    void sectionWanted(std::optional<int> section);
    void mapEdited(const std::string& map);
    void notWritten(const QString& path);

private:
    enum Page { Trajectories, Signals, Space, Record };
    QWidget* makeMotion();
    QWidget* makeRecord();
    void buildBar();
    void showSection();
    void showMotion();
    void showRecord();
    void showSpace();
    void markAngle();
    void markNear(double x_um, double y_um);
    void markInSpace();

    MarkedAngle& angle_;
    std::shared_ptr<const SpindlePicture> picture_;
    std::string channels_;
    SectionBar* section_;
    AngleBar* angleBar_;
    QCheckBox* all_;
    QLabel* synthetic_;
    QTabWidget* pages_;
    ChartView* axes_;
    QComboBox* probe_;
    QLabel* motionText_;
    PolarView* motion_;
    ChartView* coordinates_;
    ChartView* signals_;
    SceneView* scene_;
    QLabel* spaceText_;
    ChannelTable* channelTable_;
    QLabel* recordText_;
    std::shared_ptr<const trajectory::TrajectoryResult> inScene_;
};

}  // namespace lathelier
