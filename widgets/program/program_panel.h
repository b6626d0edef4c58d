// The panel "Program": moves, errors and remaining stock of an NC program.
#pragma once

#include "engine/deflection/toolpath_task.h"
#include "widgets/deflection_common/turning_panel.h"

namespace lathelier::program_panel {

using ProgramOutcome = deflection::ToolpathOutcome;

class ProgramViews;

/// The panel's line of the panel table.
PanelFacts programPanelFacts();

class ProgramPanel : public deflection_common::TurningPanel<ProgramOutcome> {
    Q_OBJECT

public:
    explicit ProgramPanel(Session& session, QWidget* parent = nullptr);

    ProgramViews& views() const { return *views_; }

    /// Writes the text of the editor to a file, which becomes the program of the project. Errors of io::writeFile().
    void saveTo(const QString& path);

protected:
    void showResult(const std::shared_ptr<const ProgramOutcome>& outcome) override;
    std::vector<PanelExport> exports() const override;
    void showPlace(const report::Place& place) override;
    void retranslate() override;

private:
    void keepDraft();
    void setDraft(const QString& step, const std::optional<std::string>& utf8);
    void askAndSave();

    ProgramViews* views_;
};

}  // namespace lathelier::program_panel
