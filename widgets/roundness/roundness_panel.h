// The panel "Roundness": how round is this section, by which circle and filter, and how sure is that?
#pragma once

#include "widgets/trajectory_common/spindle_panel.h"

namespace lathelier::roundness_panel {

class RoundnessViews;

/// The panel's line of the panel table.
PanelFacts roundnessPanelFacts();

class RoundnessPanel : public trajectory_common::SpindlePanel {
    Q_OBJECT

public:
    explicit RoundnessPanel(Session& session, QWidget* parent = nullptr);

    RoundnessViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const trajectory_common::SpindlePicture>& picture) override;
    void showPlace(const report::Place& place) override;
    report::Answer answer(const trajectory_common::SpindlePicture& picture) const override;
    report::Document document(const trajectory_common::SpindlePicture& picture) const override;
    std::vector<PanelExport> exports() const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    RoundnessViews* views_;
};

}  // namespace lathelier::roundness_panel
