// The views of one profile's roundness, linked: polar plot, spectrum, tables. An angle or an undulation picked in one
// is marked in the others.
#pragma once

#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QWidget>

#include "widgets/core/copy_table.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/polar_view.h"
#include "widgets/trajectory_common/section_bar.h"

namespace lathelier {

class RoundnessViews : public QWidget {
    Q_OBJECT

public:
    explicit RoundnessViews(MarkedAngle& angle, QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const SpindlePicture>& picture, bool sectionChosen);

    /// Draws this undulation in the polar plot too; none: takes it away.
    void markHarmonic(std::optional<int> upr);

    void retranslate();

signals:
    void sectionWanted(std::optional<int> section);
    void notWritten(const QString& path);

private:
    void buildBar();
    void showPolar();
    void showTables();
    void markAngle();

    MarkedAngle& angle_;
    std::shared_ptr<const SpindlePicture> picture_;
    std::optional<int> harmonic_;
    std::optional<int> harmonicBefore_;  ///< the last click
    SectionBar* section_;
    QToolButton* form_;
    QToolButton* laid_;
    QLabel* difference_;
    QLabel* synthetic_;
    PolarView* polar_;
    ChartView* spectrum_;
    QTabWidget* tabs_;
    CopyTable* circles_;
    CopyTable* methods_;
    CopyTable* hints_;
    CopyTable* numbers_;
};

}  // namespace lathelier
