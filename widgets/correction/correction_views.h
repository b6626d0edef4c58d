// The views of a corrected program: both programs side by side with the reason of every change, the correction along z,
// the error before and after, other machines.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/correction/diff_model.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::correction_panel {

class CorrectionViews : public QWidget {
    Q_OBJECT

public:
    explicit CorrectionViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const DeflectionOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    QTableView* lines() const { return lines_; }
    DiffModel* model() const { return model_; }
    plot::ChartView* correction() const { return correction_; }
    plot::ChartView* residual() const { return residual_; }
    void retranslate();

signals:
    void taken(qlonglong line, bool take);  ///< see DiffModel::taken()
    void checkRequested();                  ///< request to check the corrected program against drawing and stock
    void notWritten(const QString& path);   ///< the system refused to write this file

private:
    void show();
    void markRow(int row);

    std::shared_ptr<const DeflectionOutcome> outcome_;
    PrimaryViews* primaryViews_;
    QTableView* lines_;
    DiffModel* model_;
    QCheckBox* onlyChanges_;
    QToolButton* check_;
    QLabel* reason_;  ///< full reason of the selected row
    plot::ChartView* correction_;
    plot::ChartView* residual_;
    CopyTable* robustness_;
};

}  // namespace lathelier::correction_panel
