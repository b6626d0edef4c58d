// The panel of workspace Inspection: how far is the copy from the original, where, and how sure is that?
#pragma once

#include "widgets/compare/compare_series.h"
#include "widgets/core/panel/panel.h"
#include "widgets/core/task/task.h"

class QToolButton;

namespace lathelier::compare_panel {

class CompareViews;

/// The panel's line of the panel table.
PanelFacts comparePanelFacts();

class ComparePanel : public Panel<ComparePicture> {
    Q_OBJECT

public:
    explicit ComparePanel(Session& session, QWidget* parent = nullptr);

    CompareViews& views() const { return *views_; }

    /// Reference and copy change places; one undo step.
    void swapInputs();

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const ComparePicture>& picture) override;
    report::Answer answer(const ComparePicture& picture) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void showPlace(const report::Place& place) override;
    Notes notes(const ComparePicture& picture) const override;
    report::Document document(const ComparePicture& picture) const override;
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
    int drags_ = 0;  ///< of the tolerance; each is one undo step
    std::shared_ptr<LastComparison> last_;
    std::shared_ptr<KnownCopies> known_;
    std::vector<registration::CopySummary> copies_;  ///< the one on screen and the further ones; empty: not known yet
    Task series_;                                    ///< compares the further copies
};

}  // namespace lathelier::compare_panel
