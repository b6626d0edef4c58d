// The views of the proof: the copy's diameters over the predicted error along z, its rows with E_n, the steps of the
// chain with their files, and every number with its place.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <memory>

#include "widgets/chain/chain_picture.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::chain_panel {

class ChainViews : public QWidget {
    Q_OBJECT

public:
    explicit ChainViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const ChainPicture>& picture);
    void showStretch(const Interval& z_mm);
    void setPresenting(bool presenting);  ///< without the buttons
    void retranslate();

    HeroViews* heroes() const { return heroes_; }
    plot::ChartView* chart() const { return chart_; }
    CopyTable* rows() const { return rows_; }
    CopyTable* numbers() const { return numbers_; }
    QPushButton* takeFit() const { return takeFit_; }

signals:
    void fitWanted();                      ///< what was fitted is to go to the machine
    void notWritten(const QString& path);  ///< the system refused to write a picture

private:
    void show();

    std::shared_ptr<const ChainPicture> picture_;
    HeroViews* heroes_;
    plot::ChartView* chart_;
    CopyTable* rows_;
    CopyTable* fit_;
    CopyTable* steps_;
    CopyTable* files_;
    CopyTable* numbers_;
    QPushButton* takeFit_;
};

}  // namespace lathelier::chain_panel
