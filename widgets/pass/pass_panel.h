// The panel "Pass": is a whole pass stable, while the shaft behind the tool gets thinner, and at which speed?
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/pass/pass_outcome.h"

namespace lathelier::pass_panel {

class PassViews;

/// The panel's line of the panel table.
PanelFacts passPanelFacts();

class PassPanel : public Panel<PassOutcome> {
    Q_OBJECT

public:
    explicit PassPanel(Session& session, QWidget* parent = nullptr);

    PassViews& views() const { return *views_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const PassOutcome>& outcome) override;
    report::Answer answer(const PassOutcome& outcome) const override;
    Notes notes(const PassOutcome& outcome) const override { return outcome.notes; }
    report::Document document(const PassOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void movePoint(double speed_rpm, double depth_mm, bool dropped);

    PassViews* views_;
    int gesture_ = 0;  ///< drags of the operating point so far: one undo step each
};

}  // namespace lathelier::pass_panel
