// The panel "Drawing": drawing, CAD files and tables needed to make a shaft.
#pragma once

#include "engine/cad/task/draw_task.h"
#include "widgets/core/panel/task_panel.h"
#include "widgets/drawing/drawing_views.h"

namespace lathelier::drawing_panel {

/// The panel's line of the panel table.
PanelFacts drawingPanelFacts();

/// A file or item fills the table of segments; once the table is edited, it has precedence until another input is
/// chosen or the table is emptied.
class DrawingPanel : public TaskPanel<cad::DrawOutcome> {
    Q_OBJECT

public:
    explicit DrawingPanel(Session& session, QWidget* parent = nullptr);

    DrawingViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    void showResult(const std::shared_ptr<const cad::DrawOutcome>& outcome) override;
    std::vector<PanelExport> exports() const override;
    QString understood(const InputRole& role, const project::Source& source) const override;
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override;
    void retranslate() override;

private:
    void editRows(const QString& step, const RowsChange& change, const QString& merge_key);
    void editBores(const QString& step, const BoresChange& change);
    void followTable(const std::string& key, const Value& table, int gesture, const QString& step);
    void keepShaft();

    DrawingViews* views_;
};

}  // namespace lathelier::drawing_panel
