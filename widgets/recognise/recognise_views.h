// The views of a recognition, linked: meridian with residuals, rows, 3-D, the published table, numbers. A row selected
// in one is marked in all.
#pragma once

#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QWidget>
#include <memory>
#include <optional>

#include "engine/cad/task/recognize_task.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/part_common/row_chart.h"
#include "widgets/part_common/row_menu.h"
#include "widgets/recognise/rows_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::recognise_panel {

class RecogniseViews : public QWidget {
    Q_OBJECT

public:
    explicit RecogniseViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const cad::RecognizeOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    RowsView* rows() const { return rows_; }

    /// The camera, saved with the project.
    Values view() const;
    void restoreView(const Values& kept);

    void markRow(std::optional<std::size_t> row);            ///< index into Recognition::segments
    void markStretch(double from_mm, double to_mm);          ///< marks the row at an interval of z
    std::optional<std::size_t> row() const { return row_; }  ///< marked row

    /// Commands of a row of the outside; `z_mm`: position of a split.
    part_common::RowVerbs verbsOf(std::size_t row, std::optional<double> z_mm = {});

    void retranslate();

signals:
    void shaftRequested();  ///< request to store the shaft in the project
    void changeRequested(const QString& step, const lathelier::features::RowChange& change);
    void foundRequested();                 ///< request to return to the recognised rows
    void notWritten(const QString& path);  ///< the file could not be written

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void openChartMenu(QMenu* menu, double z_mm);
    void show();
    void showScan();
    void pointOut(std::optional<std::size_t> row);
    void pickAt(double z_mm);

    std::shared_ptr<const cad::RecognizeOutcome> outcome_;
    std::optional<std::size_t> row_;
    PrimaryViews* primaryViews_;
    QSplitter* charts_;
    part_common::RowChart* meridian_;
    part_common::RowChart* residuals_;
    RowsView* rows_;
    scene::SceneView* scene_;
    CopyTable* steps_;
    QLabel* beside_;
    CopyTable* numbers_;
    QToolButton* shaft_;
    QToolButton* found_;
    QLabel* synthetic_;
};

}  // namespace lathelier::recognise_panel
