// The panel "Program": moves, errors and remaining stock of an NC program.
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/program/program_outcome.h"

namespace lathelier::program_panel {

class ProgramViews;

/// The panel's line of the panel table.
PanelFacts programPanelFacts();

class ProgramPanel : public Panel<ProgramOutcome> {
    Q_OBJECT

public:
    explicit ProgramPanel(Session& session, QWidget* parent = nullptr);

    ProgramViews& views() const { return *views_; }

    /// Writes the text of the editor to a file, which becomes the program of the project. Errors of io::writeFile().
    void saveTo(const QString& path);

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const ProgramOutcome>& outcome) override;
    report::Answer answer(const ProgramOutcome& outcome) const override;
    Notes notes(const ProgramOutcome& outcome) const override { return outcome.notes; }
    report::Document document(const ProgramOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    void showPlace(const report::Place& place) override;
    void retranslate() override;

private:
    void keepDraft();
    void setDraft(const QString& step, const std::optional<std::string>& utf8);
    void askAndSave();

    ProgramViews* views_;
};

}  // namespace lathelier::program_panel
