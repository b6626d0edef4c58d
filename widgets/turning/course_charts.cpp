#include "widgets/turning/course_charts.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace lathelier::turning_panel {
namespace {

constexpr std::int64_t usual =
    (1 << static_cast<int>(cam::Course::Speed)) | (1 << static_cast<int>(cam::Course::Roughness));
constexpr const char* names[] = {"Speed", "CuttingSpeed", "Frequency", "Roughness"};
constexpr int leastRows = 4;  // of type: title, numbers of the axis, and a curve

}  // namespace

CourseCharts::CourseCharts(plot::ChartView* leader, QWidget* parent) : QWidget(parent)
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(4, 0, 4, 0);
    row->setSpacing(16);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    for (std::size_t i = 0; i < count; ++i) {
        boxes_[i] = new QCheckBox;
        boxes_[i]->setObjectName(QString("course") + names[i]);
        boxes_[i]->setChecked(((usual >> i) & 1) != 0);
        row->addWidget(boxes_[i]);
        charts_[i] = new plot::ChartView;
        charts_[i]->setObjectName(QString("turningCourse") + names[i]);
        charts_[i]->setMinimumHeight(leastRows * fontMetrics().height());
        charts_[i]->followX(leader);
        column->addWidget(charts_[i], 1);
        connect(boxes_[i], &QCheckBox::toggled, this, &CourseCharts::arrange);
        connect(charts_[i], &plot::PlotWidget::notWritten, this, &CourseCharts::notWritten);
    }
    row->addStretch(1);
    arrange();
}

void CourseCharts::setOutcome(const cam::TurningOutcome& outcome, std::size_t setup)
{
    for (std::size_t i = 0; i < count; ++i) {
        plots_[i] = coursePlot(outcome, setup, static_cast<cam::Course>(i));
        boxes_[i]->setEnabled(!plots_[i].curves.empty());
    }
    arrange();
}

/// Only the lowest chart has an axis title.
void CourseCharts::arrange()
{
    bool is_lowest = true;
    for (std::size_t i = count; i-- > 0;) {
        const bool seen = boxes_[i]->isChecked() && boxes_[i]->isEnabled();
        charts_[i]->setVisible(seen);
        if (!seen || plots_[i].curves.empty()) continue;
        report::Plot plot = plots_[i];
        if (!is_lowest) plot.x.title = report::Caption(std::string());
        if (!is_lowest) plot.x.unit = {};
        is_lowest = false;
        charts_[i]->setData(std::move(plot));
    }
}

std::int64_t CourseCharts::shown() const
{
    std::int64_t bits = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (boxes_[i]->isChecked()) bits |= std::int64_t{1} << i;
    return bits;
}

void CourseCharts::setShown(std::int64_t courses)
{
    for (std::size_t i = 0; i < count; ++i) {
        const QSignalBlocker quiet(boxes_[i]);
        boxes_[i]->setChecked((((courses > 0 ? courses : usual) >> i) & 1) != 0);
    }
    arrange();
}

void CourseCharts::setMarker(double z_mm)
{
    for (plot::ChartView* chart : charts_) chart->setMarker(z_mm);
}

void CourseCharts::retranslate()
{
    box(cam::Course::Speed)->setText(tr("N"));
    box(cam::Course::Speed)->setToolTip(tr("Speed of the spindle along the part"));
    box(cam::Course::CuttingSpeed)->setText(tr("v_c"));
    box(cam::Course::CuttingSpeed)->setToolTip(tr("Cutting speed along the part"));
    box(cam::Course::Frequency)->setText(tr("f_m"));
    box(cam::Course::Frequency)->setToolTip(tr("Frequency of chatter of each section; needs a spindle"));
    box(cam::Course::Roughness)->setText(tr("Rz"));
    box(cam::Course::Roughness)->setToolTip(tr("Ideal roughness along the part"));
    for (std::size_t i = 0; i < count; ++i) {
        boxes_[i]->setAccessibleName(boxes_[i]->toolTip());
        charts_[i]->setAccessibleName(boxes_[i]->toolTip());
    }
}

}  // namespace lathelier::turning_panel
