#include "engine/form/roundness_report.h"

namespace lathelier::form {

Section superimposeSection(const SuperimposeResult& result, const Language& language)
{
    const Text mm = LT_TEXT("Engine", "mm");
    const Text um = LT_TEXT("Engine", "µm");
    const QuantityTable figures{LT_TEXT("Engine", "The second profile laid on the first"),
                                {{LT_TEXT("Engine", "Largest difference"), result.largest_difference_um, um},
                                 {LT_TEXT("Engine", "Mean difference"), result.mean_difference_um, um},
                                 {LT_TEXT("Engine", "Root mean square difference"), result.rms_difference_um, um},
                                 {LT_TEXT("Engine", "Correlation of the forms"), result.correlation, {}, 4},
                                 {LT_TEXT("Engine", "Turned by"), result.rotation_deg, LT_TEXT("Engine", "°"), 3},
                                 {LT_TEXT("Engine", "Mirrored"), result.mirrored, {}},
                                 {LT_TEXT("Engine", "Shifted by, x"), result.shift_mm.x(), mm, 5},
                                 {LT_TEXT("Engine", "Shifted by, y"), result.shift_mm.y(), mm, 5},
                                 {LT_TEXT("Engine", "Radius larger by"), result.radius_difference_mm, mm, 5}}};
    Plot plot;
    plot.title = LT_TEXT("Engine", "Both profiles");
    plot.x = {LT_TEXT("Engine", "Angle"), LT_TEXT("Engine", "°")};
    plot.y = {LT_TEXT("Engine", "Deviation"), um};
    plot.curves = {{LT_TEXT("Engine", "first"), result.angle_deg, result.first_um, Curve::Style::Line, {}, 0},
                   {LT_TEXT("Engine", "second"), result.angle_deg, result.second_um, Curve::Style::Line, {}, 1}};
    plot.x.range = Interval{0, 360};
    Headline answer;
    answer.text = fill(text(LT_TEXT("Engine", "largest difference {largest} µm · mean {mean} µm"), language),
                       {{"largest", fixed(result.largest_difference_um, 2, language)},
                        {"mean", fixed(result.mean_difference_um, 2, language)}},
                       language);
    Section section{LT_TEXT("Engine", "Superimposed profiles"), {answer, figures, plot}};
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

}  // namespace lathelier::form
