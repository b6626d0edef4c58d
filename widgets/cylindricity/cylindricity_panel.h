// The panel "Cylindricity": how far is this surface from a cylinder, where, and is its axis straight?
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/cylindricity/cylindricity_outcome.h"

namespace lathelier::cylindricity_panel {

class CylindricityViews;

/// The panel's line of the panel table.
PanelFacts cylindricityPanelFacts();

class CylindricityPanel : public Panel<CylindricityOutcome> {
    Q_OBJECT

public:
    explicit CylindricityPanel(Session& session, QWidget* parent = nullptr);

    CylindricityViews& views() const { return *views_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const CylindricityOutcome>& outcome) override;
    report::Answer answer(const CylindricityOutcome& outcome) const override;
    Notes notes(const CylindricityOutcome& outcome) const override;
    report::Document document(const CylindricityOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    void offerSection(double z_mm);

    CylindricityViews* views_;
    std::shared_ptr<LastCylinder> last_;
};

}  // namespace lathelier::cylindricity_panel
