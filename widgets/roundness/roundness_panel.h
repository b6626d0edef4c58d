// The panel "Roundness": roundness of a section by circle and filter, with uncertainty.
#pragma once

#include "widgets/roundness/roundness_shown.h"
#include "widgets/trajectory_common/spindle_panel.h"

namespace lathelier::roundness_panel {

class RoundnessViews;

/// The panel's line of the panel table.
PanelFacts roundnessPanelFacts();

class RoundnessPanel : public trajectory_common::SpindlePanel<RoundnessShown> {
    Q_OBJECT

public:
    explicit RoundnessPanel(Session& session, QWidget* parent = nullptr);

    RoundnessViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const RoundnessShown>& outcome) override;
    void showPlace(const report::Place& place) override;
    report::Answer answer(const RoundnessShown& outcome) const override;
    std::vector<PanelExport> exports() const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    RoundnessViews* views_;
};

}  // namespace lathelier::roundness_panel
