// The panel "Cylindricity": how far is this surface from a cylinder, where, and is its axis straight?
#pragma once

#include "engine/form/task/cylindricity_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::cylindricity_panel {

class CylindricityViews;

/// The panel's line of the panel table.
PanelFacts cylindricityPanelFacts();

class CylindricityPanel : public TaskPanel<form::CylindricityOutcome> {
    Q_OBJECT

public:
    explicit CylindricityPanel(Session& session, QWidget* parent = nullptr);

    CylindricityViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const form::CylindricityOutcome>& outcome) override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    void offerSection(double z_mm);

    CylindricityViews* views_;
};

}  // namespace lathelier::cylindricity_panel
