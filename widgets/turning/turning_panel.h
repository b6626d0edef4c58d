// The panel "Turning program": program that turns a shaft, remaining material and findings of its check.
#pragma once

#include "engine/cam/drawn/drawn_plan.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::turning_panel {

class TurningViews;

/// The panel's line of the panel table.
PanelFacts turningPanelFacts();

/// A file fills the form of the job; once a field is edited, the form has precedence until another file is opened.
class TurningPanel : public TaskPanel<cam::TurningOutcome> {
    Q_OBJECT

public:
    explicit TurningPanel(Session& session, QWidget* parent = nullptr);

    TurningViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    void showResult(const std::shared_ptr<const cam::TurningOutcome>& outcome) override;
    report::Document document(const cam::TurningOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void showPlace(const report::Place& place) override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    void change(const QString& step, const std::function<void(project::PanelState&)>& how,
                const QString& merge_key = {});
    void followForm(const std::string& key, const Value& value, int gesture, const QString& step);
    void switchOperation(const cam::SkippedOperation& operation, bool on);
    void setOrder(const QString& step, int clamping, const std::vector<cam::OperationStep>& order);
    void keepDraft(int clamping, const std::optional<std::string>& utf8);
    void checkAgain(int clamping);

    TurningViews* views_;
};

}  // namespace lathelier::turning_panel
