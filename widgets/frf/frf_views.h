// The views of a response: magnitude with peaks to drag, phase, parts, Nyquist plot, coherence, error, modes.
#pragma once

#include <QToolButton>
#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/frf/frf_picture.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::frf_panel {

class FrfViews : public QWidget {
    Q_OBJECT

public:
    explicit FrfViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const FrfPicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    plot::ChartView* magnitude() const { return magnitude_; }
    plot::ChartView* nyquist() const { return nyquist_; }
    CopyTable* modes() const { return modes_; }
    void retranslate();

signals:
    void modeDragged(int index, double frequency_hz, double magnitude_mm_N, bool dropped);
    void fitWanted();                      ///< back from modes changed by hand
    void responseWanted();                 ///< for the lobes
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    void show();

    std::shared_ptr<const FrfPicture> picture_;
    QToolButton* use_;
    QToolButton* back_;
    HeroViews* heroes_;
    plot::ChartView* magnitude_;
    plot::ChartView* phase_;
    plot::ChartView* real_;
    plot::ChartView* imaginary_;
    plot::ChartView* nyquist_;
    plot::ChartView* coherence_;
    plot::ChartView* error_;
    CopyTable* modes_;
};

}  // namespace lathelier::frf_panel
