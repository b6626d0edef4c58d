// The panel "Trajectory": recorded signals, motions of axis and tool, error motion of the spindle.
#pragma once

#include "widgets/trajectory_common/spindle_panel.h"

namespace lathelier::trajectory_panel {

class TrajectoryViews;

/// The panel's line of the panel table.
PanelFacts trajectoryPanelFacts();

class TrajectoryPanel : public trajectory_common::SpindlePanel {
    Q_OBJECT

public:
    explicit TrajectoryPanel(Session& session, QWidget* parent = nullptr);

    TrajectoryViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const trajectory_common::SpindleOutcome>& outcome) override;
    report::Answer answer(const trajectory_common::SpindleOutcome& outcome) const override;
    report::Document document(const trajectory_common::SpindleOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    TrajectoryViews* views_;
};

}  // namespace lathelier::trajectory_panel
