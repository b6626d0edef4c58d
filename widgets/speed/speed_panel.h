// The panel "Speed", for the operator beside the lathe: which spindle speed in place of the selected one?
// Source: the operator's screen of Jasiewicz and Miądlicki, "An integrated CNC system for chatter suppression in
// turning": D, L, range of v_c, v_c give N_cor.
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/speed/speed_outcome.h"

namespace lathelier::speed_panel {

class SpeedViews;

/// The panel's line of the panel table.
PanelFacts speedPanelFacts();

class SpeedPanel : public Panel<SpeedOutcome> {
    Q_OBJECT

public:
    explicit SpeedPanel(Session& session, QWidget* parent = nullptr);

    SpeedViews& views() const { return *views_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const SpeedOutcome>& outcome) override;
    report::Answer answer(const SpeedOutcome& outcome) const override;
    Notes notes(const SpeedOutcome& outcome) const override { return outcome.notes; }
    std::optional<Error> problem(const SpeedOutcome& outcome) const override { return outcome.problem; }
    report::Document document(const SpeedOutcome& outcome) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void take(const QString& key, const Value& value);

    SpeedViews* views_;
};

}  // namespace lathelier::speed_panel
