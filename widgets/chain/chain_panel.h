// The panel "Proof of the copy": does the copy agree with the prediction, and from which input does every number
// follow? The strip of its workspace runs the chain.
#pragma once

#include "engine/chain/of_project/chain_study.h"
#include "widgets/core/panel/panel.h"
#include "widgets/core/panel/workspace_strip.h"

namespace lathelier::chain_panel {

class ChainViews;

/// Ids of the panels opened by its steps.
std::vector<std::string> panelsOfSteps();

/// The panel's line of the panel table.
PanelFacts chainPanelFacts();

/// The strip of its workspace; `ask` runs a step.
StripFacts chainStrip();

class ChainPanel : public Panel<chain::ChainOutcome> {
    Q_OBJECT

public:
    explicit ChainPanel(Session& session, QWidget* parent = nullptr);

    ChainViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const chain::ChainOutcome>& outcome) override;
    report::Answer answer(const chain::ChainOutcome& outcome) const override { return chain::answerOf(outcome); }
    Notes notes(const chain::ChainOutcome& outcome) const override { return outcome.notes; }
    report::Document document(const chain::ChainOutcome& outcome) const override { return chain::reportOf(outcome); }
    std::vector<PanelExport> exports() const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    void showPlace(const report::Place& place) override;
    void retranslate() override;

private:
    void takeFit();

    ChainViews* views_;
};

}  // namespace lathelier::chain_panel
