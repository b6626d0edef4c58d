// The panel "Shaft": natural frequencies, response and compliance of a shaft.
#pragma once

#include "engine/receptance/task/shaft_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::shaft_panel {

class ShaftViews;

/// The panel's line of the panel table.
PanelFacts shaftPanelFacts();

/// A file or item fills the table of segments; once the table is changed, by hand or in the drawing, it rules until
/// another input is chosen or the table is emptied.
class ShaftPanel : public TaskPanel<receptance::ShaftOutcome> {
    Q_OBJECT

public:
    explicit ShaftPanel(Session& session, QWidget* parent = nullptr);

    ShaftViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    void showResult(const std::shared_ptr<const receptance::ShaftOutcome>& outcome) override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void retranslate() override;

private:
    void moveEnd(std::size_t segment, double z_mm, double radius_mm, bool dropped);
    void keepShaft();

    ShaftViews* views_;
    int gesture_ = 0;  ///< drags so far: one undo step each
};

}  // namespace lathelier::shaft_panel
