// The views of one profile's roundness, linked: polar plot, spectrum, tables. An angle or harmonic selected in one is
// marked in the others.
#pragma once

#include <QLabel>
#include <QTabWidget>
#include <QToolButton>
#include <QWidget>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/polar_view.h"
#include "widgets/roundness/roundness_shown.h"
#include "widgets/trajectory_common/section_bar.h"

namespace lathelier::roundness_panel {

class RoundnessViews : public QWidget {
    Q_OBJECT

public:
    explicit RoundnessViews(trajectory_common::MarkedAngle& angle, QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const RoundnessShown>& outcome, bool sectionChosen);

    /// Draws this harmonic in the polar plot; none: removes it.
    void markHarmonic(std::optional<int> upr);

    PrimaryViews* primaryViews() const { return primaryViews_; }

    /// The drawn harmonic and the open table, saved with the project.
    Values view() const;
    void restoreView(const Values& kept);

    void retranslate();

signals:
    void sectionRequested(std::optional<int> section);
    void notWritten(const QString& path);

private:
    void buildBar();
    void showPolar();
    void showTables();
    void markAngle();
    void askCircle();
    bool eventFilter(QObject* watched, QEvent* event) override;

    trajectory_common::MarkedAngle& angle_;
    std::shared_ptr<const RoundnessShown> outcome_;
    int pointedRow_ = -1;  ///< hovered row of the table of circles; -1: none
    std::optional<int> harmonic_;
    std::optional<int> harmonicBefore_;  ///< harmonic before the last click
    trajectory_common::SectionBar* section_;
    QToolButton* form_;
    QToolButton* laid_;
    QLabel* difference_;
    QLabel* synthetic_;
    plot::PolarView* polar_;
    plot::ChartView* spectrum_;
    PrimaryViews* primaryViews_;
    QTabWidget* tabs_;
    CopyTable* circles_;
    CopyTable* methods_;
    CopyTable* hints_;
    CopyTable* numbers_;
};

}  // namespace lathelier::roundness_panel
