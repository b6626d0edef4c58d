// The panel "Recognise": cylinders, cones and arcs of a scanned part and their sizes.
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/recognise/recognise_outcome.h"

namespace lathelier::recognise_panel {

class RecogniseViews;

/// The panel's line of the panel table.
PanelFacts recognisePanelFacts();

class RecognisePanel : public Panel<RecogniseOutcome> {
    Q_OBJECT

public:
    explicit RecognisePanel(Session& session, QWidget* parent = nullptr);

    RecogniseViews& views() const { return *views_; }

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const RecogniseOutcome>& outcome) override;
    report::Answer answer(const RecogniseOutcome& outcome) const override;
    void showPlace(const report::Place& place) override;
    Notes notes(const RecogniseOutcome& outcome) const override;
    report::Document document(const RecogniseOutcome& outcome) const override;
    std::vector<PanelExport> exports() const override;
    Values view() const override;
    void restoreView(const Values& kept) override;
    void retranslate() override;

private:
    void toggle(const std::vector<features::AcceptedSize>& sizes);
    void change(const QString& step, const features::RowChange& asked);
    void acceptAll();
    void keepShaft();

    RecogniseViews* views_;
    std::shared_ptr<LastRecognition> last_;
};

}  // namespace lathelier::recognise_panel
