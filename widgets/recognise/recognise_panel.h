// The panel "Recognise": cylinders, cones and arcs of a scanned part and their sizes.
#pragma once

#include "engine/cad/task/recognize_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::recognise_panel {

class RecogniseViews;

/// The panel's line of the panel table.
PanelFacts recognisePanelFacts();

class RecognisePanel : public TaskPanel<cad::RecognizeOutcome> {
    Q_OBJECT

public:
    explicit RecognisePanel(Session& session, QWidget* parent = nullptr);

    RecogniseViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const cad::RecognizeOutcome>& outcome) override;
    void showPlace(const report::Place& place) override;
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
};

}  // namespace lathelier::recognise_panel
