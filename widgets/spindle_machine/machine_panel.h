// The panel "Spindle": how does the chuck face of this machine give way, and how well is that known?
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/spindle_machine/machine_picture.h"

namespace lathelier::machine_panel {

class MachineViews;

/// The panel's line of the panel table.
PanelFacts machinePanelFacts();

class MachinePanel : public Panel<MachinePicture> {
    Q_OBJECT

public:
    explicit MachinePanel(Session& session, QWidget* parent = nullptr);

    MachineViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const MachinePicture>& picture) override;
    report::Answer answer(const MachinePicture& picture) const override;
    Notes notes(const MachinePicture& picture) const override;
    report::Document document(const MachinePicture& picture) const override;
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
