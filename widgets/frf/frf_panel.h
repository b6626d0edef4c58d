// The panel "FRF": which modes does a measured response show, and does the computed one agree?
#pragma once

#include "engine/receptance/task/modes_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::frf_panel {

class FrfViews;

/// The panel's line of the panel table.
PanelFacts frfPanelFacts();

class FrfPanel : public TaskPanel<receptance::ModesOutcome> {
    Q_OBJECT

public:
    explicit FrfPanel(Session& session, QWidget* parent = nullptr);

    FrfViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const receptance::ModesOutcome>& outcome) override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void dragMode(int index, double frequency_hz, double magnitude_mm_N, bool dropped);
    void goBackToTheFit();

    FrfViews* views_;
    int gesture_ = 0;  ///< number of drags of peaks, one undo step each
};

}  // namespace lathelier::frf_panel
