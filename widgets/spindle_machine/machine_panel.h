// The panel "Spindle": receptance of the chuck face of a machine, and the quality of its identification.
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/spindle_machine/machine_outcome.h"

namespace lathelier::machine_panel {

class MachineViews;

/// The panel's line of the panel table.
PanelFacts machinePanelFacts();

class MachinePanel : public Panel<MachineOutcome> {
    Q_OBJECT

public:
    explicit MachinePanel(Session& session, QWidget* parent = nullptr);

    MachineViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const MachineOutcome>& outcome) override;
    report::Answer answer(const MachineOutcome& outcome) const override;
    Notes notes(const MachineOutcome& outcome) const override;
    report::Document document(const MachineOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void retranslate() override;

private:
    void offerSpindle();

    MachineViews* views_;
};

}  // namespace lathelier::machine_panel
