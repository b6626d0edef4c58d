#include "engine/form/roundness/superimpose_report.h"

#include "engine/core/units.h"
#include "engine/form/roundness/roundness_quantities.h"
#include "engine/form/roundness/roundness_report.h"
#include "engine/report/quantity_table.h"

namespace lathelier::form {

report::Section superimposeSection(const SuperimposeResult& result)
{
    const report::QuantityTable figures =
        report::quantityTable(LT_TEXT("Engine", "The second profile laid on the first"), result,
                              {"largest_difference_um", "mean_difference_um", "rms_difference_um", "correlation",
                               "rotation_deg", "mirrored", "shift_x_mm", "shift_y_mm", "radius_difference_mm"});
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Both profiles");
    plot.x = {LT_TEXT("Engine", "Angle"), unit::deg};
    plot.y = {LT_TEXT("Engine", "Deviation"), unit::um};
    plot.curves = {
        {LT_TEXT("Engine", "first"), result.angle_deg, result.first_um, report::Curve::Style::Line, {}, 0},
        {LT_TEXT("Engine", "second"), result.angle_deg, result.second_um, report::Curve::Style::Line, {}, 1}};
    plot.x.range = Interval{0, 360};
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Largest difference of the profiles");
    answer.value = result.largest_difference_um;
    answer.unit = unit::um;
    answer.decimals = 2;
    answer.sentence = LT_TEXT("Engine", "mean {mean_um:2} µm");
    answer.values = {{"mean_um", result.mean_difference_um}};
    report::Section section{LT_TEXT("Engine", "Superimposed profiles"), {answer, figures, plot}};
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::PolarPlot superimposedPolarPlot(const SuperimposeResult& result, double base_radius_mm)
{
    report::PolarPlot plot;
    plot.title = LT_TEXT("Engine", "Laid over each other");
    plot.base_radius_mm = base_radius_mm;
    const auto add = [&](const report::Caption& name, const std::vector<double>& deviation_um, int colour) {
        report::PolarPlot::Trace trace;
        trace.name = name;
        trace.angle_deg = result.angle_deg;
        trace.deviation_um = deviation_um;
        trace.colour = colour;
        plot.traces.push_back(std::move(trace));
    };
    add(LT_TEXT("Engine", "profile"), result.first_um, 0);
    add(LT_TEXT("Engine", "trace"), result.second_um, 1);
    std::vector<double> difference_um = result.second_um;
    for (std::size_t i = 0; i < difference_um.size(); ++i) difference_um[i] -= result.first_um[i];
    add(LT_TEXT("Engine", "difference"), difference_um, 6);
    return plot;
}

}  // namespace lathelier::form
