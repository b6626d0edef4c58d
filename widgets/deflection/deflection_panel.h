// The panel "Deflection": diameter error of the program caused by the deflection of the work.
#pragma once

#include "widgets/deflection_common/turning_panel.h"

namespace lathelier::deflection_panel {

class DeflectionViews;

/// The panel's line of the panel table.
PanelFacts deflectionPanelFacts();

class DeflectionPanel : public deflection_common::TurningPanel<deflection::DeflectionOutcome> {
    Q_OBJECT

public:
    explicit DeflectionPanel(Session& session, QWidget* parent = nullptr);

    DeflectionViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const deflection::DeflectionOutcome>& outcome) override;
    void retranslate() override;

private:
    DeflectionViews* views_;
};

}  // namespace lathelier::deflection_panel
