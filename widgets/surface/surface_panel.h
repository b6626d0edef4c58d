// The panel "Surface": chatter marks on a surface, the vibration that caused them, and comparison with a second
// picture.
#pragma once

#include "widgets/core/panel/task_panel.h"
#include "widgets/surface/shown_outcome.h"

namespace lathelier::surface_panel {

class SurfaceViews;

/// The panel's line of the panel table.
PanelFacts surfacePanelFacts();

class SurfacePanel : public TaskPanel<ShownOutcome> {
    Q_OBJECT

public:
    explicit SurfacePanel(Session& session, QWidget* parent = nullptr);

    SurfaceViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    void showResult(const std::shared_ptr<const ShownOutcome>& outcome) override;
    Notes notes(const ShownOutcome& outcome) const override { return outcome.asks() ? Notes{} : outcome.notes; }
    std::optional<Error> problem(const ShownOutcome& outcome) const override { return outcome.refused; }
    std::vector<PanelExport> exports() const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    void setRegion(int image, const std::optional<QRectF>& region);
    void setScale(int image, double pixels, double mm);
    void setDirection(int image, double direction_deg);
    void setAlike(bool alike);
    void lay(const QPointF& further_px);
    void chooseCandidate(double frequency_hz);
    void setMade(const std::string& key, const Value& value, int gesture);
    void connectQuiz();

    SurfaceViews* views_;
};

}  // namespace lathelier::surface_panel
