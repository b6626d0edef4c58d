// The panel "Deflection": what diameter error does the program leave, because the work gives way?
#pragma once

#include "widgets/deflection_common/turning_panel.h"

namespace lathelier::deflection_panel {

class DeflectionViews;

/// The panel's line of the panel table.
PanelFacts deflectionPanelFacts();

class DeflectionPanel : public deflection_common::TurningPanel {
    Q_OBJECT

public:
    explicit DeflectionPanel(Session& session, QWidget* parent = nullptr);

    DeflectionViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const deflection_common::DeflectionPicture>& picture) override;
    report::Answer answer(const deflection_common::DeflectionPicture& picture) const override;
    std::vector<PanelExport> exports() const override;
    void retranslate() override;

private:
    DeflectionViews* views_;
};

}  // namespace lathelier::deflection_panel
