// The panel "Lobes": stable depth of cut over the speed, and a better speed.
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/lobes/lobes_outcome.h"

namespace lathelier::lobes_panel {

class LobesViews;

/// The panel's line of the panel table.
PanelFacts lobesPanelFacts();

class LobesPanel : public Panel<LobesOutcome> {
    Q_OBJECT

public:
    explicit LobesPanel(Session& session, QWidget* parent = nullptr);

    LobesViews& views() const { return *views_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const LobesOutcome>& outcome) override;
    report::Answer answer(const LobesOutcome& outcome) const override;
    Notes notes(const LobesOutcome& outcome) const override;
    report::Document document(const LobesOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void moveOperatingPoint(double speed_rpm, std::optional<double> depth, bool dropped);

    LobesViews* views_;
    int gesture_ = 0;  ///< number of drags of the operating point, one undo step each
};

}  // namespace lathelier::lobes_panel
