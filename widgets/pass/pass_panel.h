// The panel "Pass": is a whole pass stable, while the shaft behind the tool gets thinner, and at which speed? The task
// lobes with a pass.
#pragma once

#include "engine/stability/task/lobes_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::pass_panel {

class PassViews;

/// The panel's line of the panel table.
PanelFacts passPanelFacts();

class PassPanel : public TaskPanel<stability::LobesOutcome> {
    Q_OBJECT

public:
    explicit PassPanel(Session& session, QWidget* parent = nullptr);

    PassViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const stability::LobesOutcome>& outcome) override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void movePoint(double speed_rpm, double depth_mm, bool dropped);

    PassViews* views_;
    int gesture_ = 0;  ///< drags of the operating point so far: one undo step each
};

}  // namespace lathelier::pass_panel
