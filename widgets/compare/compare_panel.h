// The panel of the question Copy: deviation of the copy from the original, its location and uncertainty.
#pragma once

#include "engine/cad/task/compare_task.h"
#include "widgets/core/panel/task_panel.h"
#include "widgets/core/task/task.h"

class QToolButton;

namespace lathelier::compare_panel {

class CompareViews;

/// The panel's entry in the panel table.
PanelFacts comparePanelFacts();

class ComparePanel : public TaskPanel<cad::CompareOutcome> {
    Q_OBJECT

public:
    explicit ComparePanel(Session& session, QWidget* parent = nullptr);

    CompareViews& views() const { return *views_; }

    /// Reference and copy change places; one undo step.
    void swapInputs();

protected:
    void showResult(const std::shared_ptr<const cad::CompareOutcome>& outcome) override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void showPlace(const report::Place& place) override;
    report::Document document(const cad::CompareOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    void addSwapButton();
    void offerSection(double z_mm);
    void askZone(double from_mm, double to_mm);
    void dragTolerance(double tolerance_mm, bool dropped);
    void showCopy(int number);

    CompareViews* views_;
    QToolButton* swap_ = nullptr;
    int drags_ = 0;                                  ///< number of drags of the tolerance, each one undo step
    std::vector<registration::CopySummary> copies_;  ///< the shown copy and the further ones; empty: not computed yet
    Task series_;                                    ///< compares the further copies
};

}  // namespace lathelier::compare_panel
