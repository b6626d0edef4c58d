// The panel "Series": a characteristic of many parts over time, from the archive, with its limits; a click on a point
// shows its evaluation, and opens it as it was. The task spc.
#pragma once

#include "engine/series/series_task.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::series_panel {

class SeriesViews;

/// The panel's line of the panel table.
PanelFacts seriesPanelFacts();

class SeriesPanel : public TaskPanel<series::SeriesOutcome> {
    Q_OBJECT

public:
    explicit SeriesPanel(Session& session, QWidget* parent = nullptr);

    SeriesViews& views() const { return *views_; }

protected:
    void showResult(const std::shared_ptr<const series::SeriesOutcome>& outcome) override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void showPlace(const report::Place& place) override;
    void retranslate() override;

private:
    void choosePart(const std::string& uuid);
    void chooseCharacteristic(const std::string& task, const std::string& key);
    void open(const std::string& uuid);

    SeriesViews* views_;
};

}  // namespace lathelier::series_panel
