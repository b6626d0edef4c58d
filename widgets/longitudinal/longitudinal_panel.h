// The panel "Longitudinal": the whole workpiece, section by section, from its free end to the chuck.
#pragma once

#include "engine/trajectory/task/trajectory_task.h"
#include "widgets/trajectory_common/spindle_panel.h"

namespace lathelier::longitudinal_panel {

class LongitudinalViews;

/// The panel's line of the panel table.
PanelFacts longitudinalPanelFacts();

class LongitudinalPanel : public trajectory_common::SpindlePanel<trajectory::TrajectoryOutcome> {
    Q_OBJECT

public:
    explicit LongitudinalPanel(Session& session, QWidget* parent = nullptr);

    LongitudinalViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const trajectory::TrajectoryOutcome>& outcome) override;
    report::Document document(const trajectory::TrajectoryOutcome& outcome) const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    LongitudinalViews* views_;
};

}  // namespace lathelier::longitudinal_panel
