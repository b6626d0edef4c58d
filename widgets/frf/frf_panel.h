// The panel "FRF": which modes does a measured response show, and does the computed one agree?
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/frf/frf_outcome.h"

namespace lathelier::frf_panel {

class FrfViews;

/// The panel's line of the panel table.
PanelFacts frfPanelFacts();

class FrfPanel : public Panel<FrfOutcome> {
    Q_OBJECT

public:
    explicit FrfPanel(Session& session, QWidget* parent = nullptr);

    FrfViews& views() const { return *views_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const FrfOutcome>& outcome) override;
    report::Answer answer(const FrfOutcome& outcome) const override;
    Notes notes(const FrfOutcome& outcome) const override;
    report::Document document(const FrfOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void dragMode(int index, double frequency_hz, double magnitude_mm_N, bool dropped);
    void goBackToTheFit();
    void offerResponse();

    FrfViews* views_;
    int gesture_ = 0;  ///< number of drags of peaks, one undo step each
};

}  // namespace lathelier::frf_panel
