#include "engine/chain/normalized_error.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/units.h"

namespace lathelier::chain {
namespace {

constexpr double endShare = 0.1;  // share of a row excluded at each end, where other tools may finish the corners

/// Mean along z of what is given at ascending places, between two of them; repeated positions are steps. None: no data
/// in the interval.
std::optional<double> meanAlong(const std::vector<double>& z_mm, const std::vector<double>& value, double from_mm,
                                double to_mm)
{
    double sum = 0, length_mm = 0;
    for (std::size_t i = 0; i + 1 < z_mm.size() && i + 1 < value.size(); ++i) {
        const double low = std::max(from_mm, z_mm[i]), high = std::min(to_mm, z_mm[i + 1]);
        const double step_mm = z_mm[i + 1] - z_mm[i];
        if (!(high > low) || !std::isfinite(value[i]) || !std::isfinite(value[i + 1])) continue;
        const double middle = (low + high) / 2;
        sum += (value[i] + (value[i + 1] - value[i]) * (middle - z_mm[i]) / step_mm) * (high - low);
        length_mm += high - low;
    }
    // Predictions covering less than half of a row are not used for its mean.
    if (length_mm < 0.5 * (to_mm - from_mm) || length_mm <= 0) return std::nullopt;
    return sum / length_mm;
}

}  // namespace

std::vector<ComparedError> compareErrors(const PredictedErrors& predicted, const std::vector<MeasuredError>& measured)
{
    std::vector<ComparedError> places;
    for (const MeasuredError& row : measured) {
        const double inset_mm = endShare * (row.z_end_mm - row.z_start_mm);
        const double from_mm = row.z_start_mm + inset_mm, to_mm = row.z_end_mm - inset_mm;
        const auto mean = meanAlong(predicted.z_mm, predicted.error_um, from_mm, to_mm);
        if (!mean) continue;
        ComparedError place{row.row, row.z_start_mm, row.z_end_mm, *mean, 0, row.error_um, row.uncertainty_um, 0};
        const auto low = meanAlong(predicted.z_mm, predicted.low_um, from_mm, to_mm);
        const auto high = meanAlong(predicted.z_mm, predicted.high_um, from_mm, to_mm);
        if (low && high) place.predicted_uncertainty_um = (*high - *low) / 2;
        const double both_um = std::hypot(place.measured_uncertainty_um, place.predicted_uncertainty_um);
        if (!(both_um > 0)) continue;
        place.normalized_error = (place.measured_um - place.predicted_um) / both_um;
        places.push_back(place);
    }
    return places;
}

Json toJson(const std::vector<ComparedError>& places)
{
    Json list = Json::array();
    std::optional<double> largest;
    for (const ComparedError& place : places) {
        list.push_back({{"row", place.row},
                        {"z_start_mm", place.z_start_mm},
                        {"z_end_mm", place.z_end_mm},
                        {"predicted_um", place.predicted_um},
                        {"predicted_uncertainty_um", place.predicted_uncertainty_um},
                        {"measured_um", place.measured_um},
                        {"measured_uncertainty_um", place.measured_uncertainty_um},
                        {"normalized_error", place.normalized_error}});
        if (!largest || std::abs(place.normalized_error) > std::abs(*largest)) largest = place.normalized_error;
    }
    return {{"places", list}, {"largest_normalized_error", number(largest)}};
}

report::Plot errorsPlot(const PredictedErrors& predicted, const std::vector<ComparedError>& places)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Predicted and measured error of the diameter");
    plot.x = {LT_TEXT("Engine", "z from the free end"), unit::mm};
    plot.y = {LT_TEXT("Engine", "Diameter error"), unit::um};
    if (!predicted.low_um.empty()) {
        report::Curve band;
        band.name = LT_TEXT("Engine", "95 % of samples");
        band.style = report::Curve::Style::Band;
        band.x = predicted.z_mm;
        band.y = predicted.high_um;
        band.y_low = predicted.low_um;
        plot.curves.push_back(std::move(band));
    }
    report::Curve line;
    line.name = LT_TEXT("Engine", "predicted");
    line.x = predicted.z_mm;
    line.y = predicted.error_um;
    plot.curves.push_back(std::move(line));
    report::Curve rows;
    rows.name = LT_TEXT("Engine", "measured, ± U");
    rows.colour = report::ColourRole::Copy;
    for (const ComparedError& place : places) {
        const double middle_mm = (place.z_start_mm + place.z_end_mm) / 2;
        // A vertical bar of ± U in the middle of a level line along the row.
        for (const auto& [z_mm, error_um] :
             {std::pair{place.z_start_mm, place.measured_um}, std::pair{middle_mm, place.measured_um},
              std::pair{middle_mm, place.measured_um - place.measured_uncertainty_um},
              std::pair{middle_mm, place.measured_um + place.measured_uncertainty_um},
              std::pair{middle_mm, place.measured_um}, std::pair{place.z_end_mm, place.measured_um},
              std::pair{place.z_end_mm, notANumber}}) {
            rows.x.push_back(z_mm);
            rows.y.push_back(error_um);
        }
    }
    plot.curves.push_back(std::move(rows));
    return plot;
}

}  // namespace lathelier::chain
