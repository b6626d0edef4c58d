// The panel of workspace Inspection: deviation of the copy from the original, its location and uncertainty.
#pragma once

#include "widgets/compare/compare_series.h"
#include "widgets/core/panel/panel.h"
#include "widgets/core/task/task.h"

class QToolButton;

namespace lathelier::compare_panel {

class CompareViews;

/// The panel's entry in the panel table.
PanelFacts comparePanelFacts();

class ComparePanel : public Panel<CompareOutcome> {
    Q_OBJECT

public:
    explicit ComparePanel(Session& session, QWidget* parent = nullptr);

    CompareViews& views() const { return *views_; }

    /// Reference and copy change places; one undo step.
    void swapInputs();

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const CompareOutcome>& outcome) override;
    report::Answer answer(const CompareOutcome& outcome) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void showPlace(const report::Place& place) override;
    Notes notes(const CompareOutcome& outcome) const override;
    report::Document document(const CompareOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    void addSwapButton();
    void offerSection(double z_mm);
    void askZone(double from_mm, double to_mm);
    void showCopy(int number);

    CompareViews* views_;
    QToolButton* swap_ = nullptr;
    int drags_ = 0;  ///< number of drags of the tolerance, each one undo step
    std::shared_ptr<LastComparison> last_;
    std::shared_ptr<KnownCopies> known_;
    std::vector<registration::CopySummary> copies_;  ///< the shown copy and the further ones; empty: not computed yet
    Task series_;                                    ///< compares the further copies
};

}  // namespace lathelier::compare_panel
