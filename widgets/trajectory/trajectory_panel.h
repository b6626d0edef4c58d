// The panel "Trajectory": recorded signals, motions of axis and tool, error motion of the spindle.
#pragma once

#include "engine/trajectory/task/trajectory_task.h"
#include "widgets/trajectory_common/spindle_panel.h"

namespace lathelier::trajectory_panel {

class TrajectoryViews;

/// The panel's line of the panel table.
PanelFacts trajectoryPanelFacts();

class TrajectoryPanel : public trajectory_common::SpindlePanel<trajectory::MotionOutcome> {
    Q_OBJECT

public:
    explicit TrajectoryPanel(Session& session, QWidget* parent = nullptr);

    TrajectoryViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const trajectory::MotionOutcome>& outcome) override;
    std::optional<Error> problem(const trajectory::MotionOutcome& outcome) const override { return outcome.problem; }
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    void setParameter(const std::string& key, const Value& value, const QString& step);

    TrajectoryViews* views_;
};

}  // namespace lathelier::trajectory_panel
