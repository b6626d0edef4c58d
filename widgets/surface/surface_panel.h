// The panel "Surface": chatter marks on a surface, the vibration that caused them, and comparison with a second
// picture.
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/surface/surface_outcome.h"

namespace lathelier::surface_panel {

class SurfaceViews;

/// The panel's line of the panel table.
PanelFacts surfacePanelFacts();

class SurfacePanel : public Panel<SurfaceOutcome> {
    Q_OBJECT

public:
    explicit SurfacePanel(Session& session, QWidget* parent = nullptr);

    SurfaceViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const SurfaceOutcome>& outcome) override;
    report::Answer answer(const SurfaceOutcome& outcome) const override;
    Notes notes(const SurfaceOutcome& outcome) const override { return outcome.asks() ? Notes{} : outcome.notes; }
    report::Document document(const SurfaceOutcome& outcome) const override;
    std::optional<Error> problem(const SurfaceOutcome& outcome) const override { return outcome.refused; }
    std::vector<PanelExport> exports() const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    Worker::Job makeReadingJob(const project::PanelState& state) const override;
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
    void sendMarks();

    SurfaceViews* views_;
};

}  // namespace lathelier::surface_panel
