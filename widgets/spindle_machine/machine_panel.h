// The panel "Spindle": receptance of the chuck face of a machine, and the quality of its identification.
#pragma once

#include "engine/receptance/task/spindle_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::machine_panel {

class MachineViews;

/// The panel's line of the panel table.
PanelFacts machinePanelFacts();

class MachinePanel : public TaskPanel<receptance::SpindleOutcome> {
    Q_OBJECT

public:
    explicit MachinePanel(Session& session, QWidget* parent = nullptr);

    MachineViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    void showResult(const std::shared_ptr<const receptance::SpindleOutcome>& outcome) override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void retranslate() override;

private:
    MachineViews* views_;
};

}  // namespace lathelier::machine_panel
