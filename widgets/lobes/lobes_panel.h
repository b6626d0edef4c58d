// The panel "Lobes": how deep may be cut at which speed without chatter, and which speed is better?
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/lobes/lobes_picture.h"

namespace lathelier::lobes_panel {

class LobesViews;

/// The panel's line of the panel table.
PanelFacts lobesPanelFacts();

class LobesPanel : public Panel<LobesPicture> {
    Q_OBJECT

public:
    explicit LobesPanel(Session& session, QWidget* parent = nullptr);

    LobesViews& views() const { return *views_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const LobesPicture>& picture) override;
    report::Answer answer(const LobesPicture& picture) const override;
    Notes notes(const LobesPicture& picture) const override;
    report::Document document(const LobesPicture& picture) const override;
    std::vector<PanelExport> exports() const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void retranslate() override;

private:
    void moveOperatingPoint(double speed_rpm, std::optional<double> depth, bool dropped);

    LobesViews* views_;
    int gesture_ = 0;  ///< drags of the operating point so far: one undo step each
};

}  // namespace lathelier::lobes_panel
