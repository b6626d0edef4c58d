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
#include "widgets/core/panel/hero_views.h"
#include "widgets/correction/diff_model.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::correction_panel {

class CorrectionViews : public QWidget {
    Q_OBJECT

public:
    explicit CorrectionViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const DeflectionPicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    QTableView* lines() const { return lines_; }
    DiffModel* model() const { return model_; }
    plot::ChartView* correction() const { return correction_; }
    plot::ChartView* residual() const { return residual_; }
    void retranslate();

signals:
    void taken(qlonglong line, bool take);  ///< as DiffModel::taken()
    void checkWanted();                     ///< of the corrected program against drawing and stock
    void notWritten(const QString& path);   ///< the system refused to write this file

private:
    void show();
    void markRow(int row);

    std::shared_ptr<const DeflectionPicture> picture_;
    HeroViews* heroes_;
    QTableView* lines_;
    DiffModel* model_;
    QCheckBox* only_changes_;
    QToolButton* check_;
    QLabel* reason_;  ///< of the selected row, in full
    plot::ChartView* correction_;
    plot::ChartView* residual_;
    CopyTable* robustness_;
};

}  // namespace lathelier::correction_panel
