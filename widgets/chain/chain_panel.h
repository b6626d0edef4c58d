// The panel "Proof of the copy": did the copy come out as predicted, and from what does every number follow? The strip
// of its workspace runs the chain.
#pragma once

#include "engine/chain/verb_asker.h"
#include "widgets/chain/chain_picture.h"
#include "widgets/core/panel/panel.h"
#include "widgets/core/panel/workspace_strip.h"

namespace lathelier::chain_panel {

class ChainViews;

/// The workspace that the strip stands in.
Workspace workspace();

/// Ids of the panels that its steps open.
std::vector<std::string> panelsOfSteps();

/// The panel's line of the panel table.
PanelFacts chainPanelFacts();

/// The strip over its workspace; `ask` answers the steps.
StripFacts chainStrip(chain::AskVerb ask);

class ChainPanel : public Panel<ChainPicture> {
    Q_OBJECT

public:
    explicit ChainPanel(Session& session, QWidget* parent = nullptr);

    ChainViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const ChainPicture>& picture) override;
    report::Answer answer(const ChainPicture& picture) const override { return chain_panel::answerOf(picture); }
    Notes notes(const ChainPicture& picture) const override { return picture.notes; }
    report::Document document(const ChainPicture& picture) const override { return chain_panel::reportOf(picture); }
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
