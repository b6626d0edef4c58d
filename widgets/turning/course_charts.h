// Speed, cutting speed, frequency of chatter and roughness along the part: small charts one below the other over the z
// of the contour, each with a box that shows it.
#pragma once

#include <QCheckBox>
#include <QWidget>
#include <array>

#include "engine/cam/drawn/plan_charts.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::turning_panel {

class CourseCharts : public QWidget {
    Q_OBJECT

public:
    static constexpr std::size_t count = 4;

    /// They share the x axis of `leader`, which must live as long.
    explicit CourseCharts(plot::ChartView* leader, QWidget* parent = nullptr);

    void setOutcome(const cam::TurningOutcome& outcome, std::size_t setup);
    plot::ChartView* chart(cam::Course course) const { return charts_[static_cast<std::size_t>(course)]; }
    QCheckBox* box(cam::Course course) const { return boxes_[static_cast<std::size_t>(course)]; }

    std::int64_t shown() const;           ///< a bit for each course that is ticked, the first one the lowest
    void setShown(std::int64_t courses);  ///< the same back; none: the usual ones
    void setMarker(double z_mm);
    void retranslate();

signals:
    void notWritten(const QString& path);  ///< the system refused to write a picture

private:
    void arrange();

    std::array<QCheckBox*, count> boxes_{};
    std::array<plot::ChartView*, count> charts_{};
    std::array<report::Plot, count> plots_{};
};

}  // namespace lathelier::turning_panel
