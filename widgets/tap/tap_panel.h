// The panel "Tap test": from hammer and sensor over time to a frequency response.
#pragma once

#include "engine/receptance/task/tap_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::tap_panel {

class TapViews;

/// The panel's line of the panel table.
PanelFacts tapPanelFacts();

class TapPanel : public TaskPanel<receptance::TapOutcome> {
    Q_OBJECT

public:
    explicit TapPanel(Session& session, QWidget* parent = nullptr);

    TapViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const receptance::TapOutcome>& outcome) override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    TapViews* views_;
};

}  // namespace lathelier::tap_panel
