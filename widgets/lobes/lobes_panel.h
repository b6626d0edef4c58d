// The panel "Lobes": stable depth of cut over the speed, and a better speed.
#pragma once

#include "engine/stability/task/lobes_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::lobes_panel {

class LobesViews;

/// The panel's line of the panel table.
PanelFacts lobesPanelFacts();

class LobesPanel : public TaskPanel<stability::LobesOutcome> {
    Q_OBJECT

public:
    explicit LobesPanel(Session& session, QWidget* parent = nullptr);

    LobesViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const stability::LobesOutcome>& outcome) override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void moveOperatingPoint(double speed_rpm, std::optional<double> depth, bool dropped);

    LobesViews* views_;
    int gesture_ = 0;  ///< number of drags of the operating point, one undo step each
};

}  // namespace lathelier::lobes_panel
