// The panel "Longitudinal": the whole workpiece, section by section, from its free end to the chuck.
#pragma once

#include "widgets/trajectory_common/spindle_panel.h"

namespace lathelier {

class LongitudinalViews;

/// The panel's line of the panel table.
PanelFacts longitudinalPanelFacts();

class LongitudinalPanel : public SpindlePanel {
    Q_OBJECT

public:
    explicit LongitudinalPanel(Session& session, QWidget* parent = nullptr);

    LongitudinalViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const SpindlePicture>& picture) override;
    Headline headline(const SpindlePicture& picture) const override;
    Document document(const SpindlePicture& picture) const override;
    std::vector<PanelExport> exports() const override;
    void retranslate() override;

private:
    LongitudinalViews* views_;
};

}  // namespace lathelier
