// What the panels of the workspace Deflection share: their inputs, one computation, their report.
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/deflection_common/deflection_picture.h"

namespace lathelier::deflection_common {

class TurningPanel : public Panel<DeflectionPicture> {
    Q_OBJECT

public:
    TurningPanel(Session& session, const PanelFacts& facts, const PanelInputs& inputs, Wanted wanted,
                 QWidget* parent = nullptr);

protected:
    Compute compute(const project::PanelState& state) const override;
    Notes notes(const DeflectionPicture& picture) const override { return picture.notes; }
    report::Document document(const DeflectionPicture& picture) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;

private:
    Wanted wanted_;
};

}  // namespace lathelier::deflection_common
