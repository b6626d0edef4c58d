// The panel "Correction": which words of the program change, why, and which error remains?
#pragma once

#include "widgets/deflection_common/turning_panel.h"

namespace lathelier::correction_panel {

class CorrectionViews;

/// The panel's line of the panel table.
PanelFacts correctionPanelFacts();

class CorrectionPanel : public deflection_common::TurningPanel<deflection::DeflectionOutcome> {
    Q_OBJECT

public:
    explicit CorrectionPanel(Session& session, QWidget* parent = nullptr);

    CorrectionViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const deflection::DeflectionOutcome>& outcome) override;
    void retranslate() override;

private:
    void take(qlonglong line, bool isTaken);

    CorrectionViews* views_;
};

}  // namespace lathelier::correction_panel
