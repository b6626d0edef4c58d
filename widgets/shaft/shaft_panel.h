// The panel "Shaft": at which frequencies does it swing, how far does its tip give way?
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/shaft/shaft_picture.h"

namespace lathelier::shaft_panel {

class ShaftViews;

/// The panel's line of the panel table.
PanelFacts shaftPanelFacts();

/// A file or item fills the table of segments; once the table is changed, by hand or in the drawing, it rules until
/// another input is chosen or the table is emptied.
class ShaftPanel : public Panel<ShaftPicture> {
    Q_OBJECT

public:
    explicit ShaftPanel(Session& session, QWidget* parent = nullptr);

    ShaftViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const ShaftPicture>& picture) override;
    report::Answer answer(const ShaftPicture& picture) const override;
    Notes notes(const ShaftPicture& picture) const override;
    report::Document document(const ShaftPicture& picture) const override;
    std::vector<PanelExport> exports() const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void retranslate() override;

private:
    void moveEnd(std::size_t segment, double z_mm, double radius_mm, bool dropped);
    void keepShaft();
    void offerResponse();

    ShaftViews* views_;
    int gesture_ = 0;  ///< drags so far: one undo step each
};

}  // namespace lathelier::shaft_panel
