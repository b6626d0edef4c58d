// The panel "Speed", for the operator beside the lathe: which spindle speed in place of the selected one?
#pragma once

#include "engine/link/control_values.h"
#include "engine/stability/task/speed_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::speed_panel {

class SpeedViews;

/// The panel's line of the panel table.
PanelFacts speedPanelFacts();

class SpeedPanel : public TaskPanel<stability::SpeedOutcome> {
    Q_OBJECT

public:
    explicit SpeedPanel(Session& session, QWidget* parent = nullptr);

    SpeedViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const stability::SpeedOutcome>& outcome) override;
    std::optional<Error> problem(const stability::SpeedOutcome& outcome) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void take(const QString& key, const Value& value);
    void takeRequest(const link::ControlValues& values);

    SpeedViews* views_;
};

}  // namespace lathelier::speed_panel
