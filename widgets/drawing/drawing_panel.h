// The panel "Drawing": what does the workshop need to make this shaft, as drawing, CAD and tables?
#pragma once

#include "widgets/core/panel/panel.h"
#include "widgets/drawing/drawing_picture.h"
#include "widgets/drawing/drawing_views.h"

namespace lathelier::drawing_panel {

/// The panel's line of the panel table.
PanelFacts drawingPanelFacts();

/// A file or item fills the table of segments; once the table is changed, it rules until another input is chosen or
/// the table is emptied.
class DrawingPanel : public Panel<DrawingPicture> {
    Q_OBJECT

public:
    explicit DrawingPanel(Session& session, QWidget* parent = nullptr);

    DrawingViews& views() const { return *views_; }
    void setPresenting(bool presenting) override;

protected:
    Compute compute(const project::PanelState& state) const override;
    void showResult(const std::shared_ptr<const DrawingPicture>& picture) override;
    report::Answer answer(const DrawingPicture& picture) const override;
    Notes notes(const DrawingPicture& picture) const override;
    report::Document document(const DrawingPicture& picture) const override;
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
