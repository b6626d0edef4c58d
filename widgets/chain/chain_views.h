// The views of the proof: the copy's diameters over the predicted error along z, its rows with E_n, the steps of the
// chain with their files, and every number with its source location.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <memory>

#include "engine/chain/of_project/chain_study.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::chain_panel {

class ChainViews : public QWidget {
    Q_OBJECT

public:
    explicit ChainViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const chain::ChainOutcome>& outcome);
    /// The steps as the folder stands now, where that was inspected after the run.
    void setLooked(const std::shared_ptr<const lathelier::chain::Dossier>& dossier);
    void showStretch(const Interval& z_mm);
    void setPresenting(bool presenting);  ///< hides the buttons
    void retranslate();

    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* chart() const { return chart_; }
    CopyTable* rows() const { return rows_; }
    CopyTable* steps() const { return steps_; }
    CopyTable* numbers() const { return numbers_; }
    QPushButton* takeFit() const { return takeFit_; }

signals:
    void stepRequested(const std::string& step);  ///< double click or Enter on a step
    void fitRequested();                          ///< request to use the fitted machine
    void notWritten(const QString& path);         ///< an image could not be written

private:
    void show();
    void showSteps();

    std::shared_ptr<const chain::ChainOutcome> outcome_;
    std::shared_ptr<const chain::Dossier> looked_;
    PrimaryViews* primaryViews_;
    plot::ChartView* chart_;
    CopyTable* rows_;
    CopyTable* fit_;
    CopyTable* steps_;
    CopyTable* files_;
    CopyTable* numbers_;
    QPushButton* takeFit_;
};

}  // namespace lathelier::chain_panel
