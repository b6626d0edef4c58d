// The views of a recognition, linked: meridian with residuals, rows, 3-D, the published table, numbers. A row pointed
// at in one is marked in all.
#pragma once

#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QWidget>
#include <memory>
#include <optional>

#include "widgets/core/panel/hero_views.h"
#include "widgets/part_common/row_chart.h"
#include "widgets/part_common/row_menu.h"
#include "widgets/recognise/rows_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::recognise_panel {

class RecogniseViews : public QWidget {
    Q_OBJECT

public:
    explicit RecogniseViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const RecognisePicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    RowsView* rows() const { return rows_; }

    /// The camera, to be kept with the project.
    Values view() const;
    void restoreView(const Values& kept);

    void markRow(std::optional<std::size_t> row);            ///< index into Recognition::segments
    void markStretch(double from_mm, double to_mm);          ///< of z
    std::optional<std::size_t> row() const { return row_; }  ///< that is marked

    /// What can be done with a row of the outside; `z_mm`: where it is cut.
    part_common::RowVerbs verbsOf(std::size_t row, std::optional<double> z_mm = {});

    void retranslate();

signals:
    void shaftWanted();  ///< keep it in the project
    void changeWanted(const QString& step, const lathelier::features::RowChange& change);
    void foundWanted();                    ///< the rows as they were recognised
    void notWritten(const QString& path);  ///< the system refused to write this file

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void openChartMenu(QMenu* menu, double z_mm);
    void show();
    void showScan();
    void pointOut(std::optional<std::size_t> row);
    void pickAt(double z_mm);

    std::shared_ptr<const RecognisePicture> picture_;
    std::optional<std::size_t> row_;
    HeroViews* heroes_;
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
