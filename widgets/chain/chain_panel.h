// The panel "Proof of the copy": does the copy agree with the prediction, and from which input does every number
// follow? A row above it runs the chain.
#pragma once

#include "engine/chain/of_project/chain_study.h"
#include "widgets/core/panel/panel.h"

namespace lathelier::chain_panel {

class ChainRunRow;
class ChainViews;

/// The panel's line of the panel table.
PanelFacts chainPanelFacts();

class ChainPanel : public Panel<chain::ChainOutcome> {
    Q_OBJECT

public:
    explicit ChainPanel(Session& session, QWidget* parent = nullptr);

    ChainViews& views() const { return *views_; }
    ChainRunRow& runRow() const { return *run_; }
    void setPresenting(bool presenting) override;

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const chain::ChainOutcome>& outcome) override;
    report::Answer answer(const chain::ChainOutcome& outcome) const override { return chain::answerOf(outcome); }
    Notes notes(const chain::ChainOutcome& outcome) const override { return outcome.notes; }
    report::Document document(const chain::ChainOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    void showPlace(const report::Place& place) override;
    void retranslate() override;

private:
    void takeFit();

    ChainViews* views_;
    ChainRunRow* run_;
};

}  // namespace lathelier::chain_panel
