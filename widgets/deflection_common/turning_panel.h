// Common base of the panels Deflection and Correction: inputs, computation, report.
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/deflection_common/deflection_outcome.h"

namespace lathelier::deflection_common {

class TurningPanel : public Panel<DeflectionOutcome> {
    Q_OBJECT

public:
    TurningPanel(Session& session, const PanelFacts& facts, const PanelInputs& inputs, StudyKind studyKind,
                 QWidget* parent = nullptr);

protected:
    Compute compute(const project::PanelState& state) const override;
    Notes notes(const DeflectionOutcome& outcome) const override { return outcome.notes; }
    report::Document document(const DeflectionOutcome& outcome) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;

private:
    StudyKind studyKind_;
};

}  // namespace lathelier::deflection_common
