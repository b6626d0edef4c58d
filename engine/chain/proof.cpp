#include "engine/chain/proof.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "engine/core/units.h"

namespace lathelier::chain {
namespace {

constexpr double clear_mm = 1;  // distance from shoulders, which the scan rounds

std::vector<double> numbersAt(const Json& json, const char* list, const char* name)
{
    std::vector<double> values;
    if (!json.contains(list) || !json[list].is_object() || !json[list].contains(name)) return values;
    for (const Json& item : json[list][name]) values.push_back(item.is_number() ? item.get<double>() : notANumber);
    return values;
}

double numberAt(const Json& json, const char* name)
{
    return json.contains(name) && json[name].is_number() ? json[name].get<double>() : notANumber;
}

/// Row number from 1; none: not an integer.
std::optional<std::int64_t> rowAt(const Json& json)
{
    if (!json.contains("row") || !json["row"].is_number_integer()) return std::nullopt;
    return json["row"].get<std::int64_t>();
}

void append(PredictedErrors& all, const PredictedErrors& more, std::size_t i, bool has_band)
{
    all.z_mm.push_back(more.z_mm[i]);
    all.error_um.push_back(more.error_um[i]);
    if (!has_band) return;
    all.low_um.push_back(more.low_um[i]);
    all.high_um.push_back(more.high_um[i]);
}

}  // namespace

PredictedErrors predictedErrors(const Json& deflected, double zero_mm, double mirrored_length_mm)
{
    PredictedErrors predicted{
        numbersAt(deflected, "final", "z_mm"), numbersAt(deflected, "final", "diameter_error_um"), {}, {}};
    predicted.error_um.resize(predicted.z_mm.size(), notANumber);
    if (numbersAt(deflected, "band", "z_mm").size() == predicted.z_mm.size()) {
        predicted.low_um = numbersAt(deflected, "band", "low_um");
        predicted.high_um = numbersAt(deflected, "band", "high_um");
        if (predicted.low_um.size() != predicted.z_mm.size() || predicted.high_um.size() != predicted.z_mm.size())
            predicted.low_um = predicted.high_um = {};
    }
    for (double& z_mm : predicted.z_mm) z_mm -= zero_mm;
    if (mirrored_length_mm > 0) {
        for (double& z_mm : predicted.z_mm) z_mm = mirrored_length_mm - z_mm;
        for (auto* values : {&predicted.z_mm, &predicted.error_um, &predicted.low_um, &predicted.high_um})
            std::reverse(values->begin(), values->end());
    }
    return predicted;
}

PredictedErrors joined(const PredictedErrors& first, const PredictedErrors& second, double split_mm)
{
    PredictedErrors all;
    const bool has_band = !first.low_um.empty() && !second.low_um.empty();
    for (std::size_t i = 0; i < first.z_mm.size(); ++i)
        if (first.z_mm[i] <= split_mm) append(all, first, i, has_band);
    for (std::size_t i = 0; i < second.z_mm.size(); ++i)
        if (second.z_mm[i] > split_mm) append(all, second, i, has_band);
    return all;
}

std::vector<MeasuredError> measuredErrors(const Json& drawn, const Json& compared)
{
    std::vector<MeasuredError> measured;
    if (!compared.contains("rows") || !drawn.contains("segments")) return measured;
    const Json& segments = drawn["segments"];
    for (const Json& row : compared["rows"]) {
        const bool is_diameter = row.contains("quantity") && row["quantity"] == "diameter";
        if (!is_diameter || !row.contains("bore") || !row["bore"].is_null()) continue;
        const double deviation_mm = numberAt(row, "deviation_mm"), uncertainty_mm = numberAt(row, "uncertainty_mm");
        const auto number = rowAt(row);
        if (!std::isfinite(deviation_mm + uncertainty_mm) || !number) continue;
        if (*number < 1 || *number > static_cast<std::int64_t>(segments.size())) continue;
        const Json& segment = segments.at(static_cast<std::size_t>(*number - 1));
        measured.push_back({*number, numberAt(segment, "z_start_mm"), numberAt(segment, "z_end_mm"),
                            1000 * deviation_mm, 1000 * uncertainty_mm});
    }
    return measured;
}

std::vector<MeasuredPlace> measuredPlaces(const Json& drawn, const Json& compared)
{
    std::vector<MeasuredPlace> places;
    if (!compared.contains("zones") || !drawn.contains("segments")) return places;
    for (const Json& zone : compared["zones"]) {
        const double from_mm = numberAt(zone, "z_start_mm"), to_mm = numberAt(zone, "z_end_mm");
        const double mean_mm = numberAt(zone, "mean_mm"), uncertainty_mm = numberAt(zone, "uncertainty_mm");
        if (!std::isfinite(from_mm + to_mm + mean_mm + uncertainty_mm) || !(uncertainty_mm > 0)) continue;
        std::int64_t number = 0;
        for (const Json& row : drawn["segments"]) {
            ++number;
            const bool is_cylinder = row["start_diameter_mm"] == row["end_diameter_mm"];
            if (!is_cylinder || from_mm < numberAt(row, "z_start_mm") - clear_mm / 2) continue;
            if (to_mm > numberAt(row, "z_end_mm") - clear_mm / 2) continue;
            places.push_back({(from_mm + to_mm) / 2, 2000 * mean_mm, 2000 * uncertainty_mm, number});
        }
    }
    return places;
}

Json proofJson(const PredictedErrors& predicted, const std::vector<ComparedError>& places,
               const std::vector<MeasuredPlace>& along)
{
    Json json = toJson(places);
    json["along"] = Json::array();
    for (const MeasuredPlace& place : along)
        json["along"].push_back({{"z_mm", place.z_mm},
                                 {"row", place.row},
                                 {"measured_um", place.error_um},
                                 {"measured_uncertainty_um", place.uncertainty_um}});
    json["predicted"] = {{"z_mm", numbers(predicted.z_mm)},
                         {"error_um", numbers(predicted.error_um)},
                         {"low_um", numbers(predicted.low_um)},
                         {"high_um", numbers(predicted.high_um)}};
    return json;
}

std::optional<Proof> proofFrom(const Json& json)
{
    if (!json.is_object() || !json.contains("places") || !json.contains("predicted")) return std::nullopt;
    Proof proof;
    PredictedErrors& predicted = proof.predicted;
    predicted = {numbersAt(json, "predicted", "z_mm"), numbersAt(json, "predicted", "error_um"),
                 numbersAt(json, "predicted", "low_um"), numbersAt(json, "predicted", "high_um")};
    const std::size_t count = predicted.z_mm.size();
    const auto fits = [count](const std::vector<double>& band) { return band.empty() || band.size() == count; };
    if (predicted.error_um.size() != count || !fits(predicted.low_um) || !fits(predicted.high_um) ||
        predicted.low_um.size() != predicted.high_um.size())
        return std::nullopt;
    for (const Json& place : json["places"]) {
        const auto row = rowAt(place);
        if (!row) return std::nullopt;
        proof.places.push_back({*row, numberAt(place, "z_start_mm"), numberAt(place, "z_end_mm"),
                                numberAt(place, "predicted_um"), numberAt(place, "predicted_uncertainty_um"),
                                numberAt(place, "measured_um"), numberAt(place, "measured_uncertainty_um"),
                                numberAt(place, "normalized_error")});
    }
    if (!json.contains("along")) return proof;
    for (const Json& place : json["along"]) {
        const auto row = rowAt(place);
        if (!row) return std::nullopt;
        proof.along.push_back({numberAt(place, "z_mm"), numberAt(place, "measured_um"),
                               numberAt(place, "measured_uncertainty_um"), *row});
    }
    return proof;
}

report::Answer proofAnswer(const Proof& proof, const std::optional<report::Finding>& copy)
{
    constexpr std::size_t most_rows = 3;
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Prediction and copy differ by");
    std::vector<ComparedError> places = proof.places;
    const auto size = [](const ComparedError& place) { return std::abs(place.normalized_error); };
    std::stable_sort(places.begin(), places.end(),
                     [&](const ComparedError& a, const ComparedError& b) { return size(a) > size(b); });
    if (copy) answer.findings.push_back(*copy);
    std::int64_t disagreeing = 0;
    for (const ComparedError& place : places) {
        if (!(size(place) > 1)) continue;
        if (++disagreeing > static_cast<std::int64_t>(most_rows)) continue;
        answer.findings.push_back(
            {LT_TEXT("Engine", "Row {row}: measured {measured:1} µm, predicted {predicted:1} µm, E_n {error:2}"),
             {{"row", place.row},
              {"measured", place.measured_um},
              {"predicted", place.predicted_um},
              {"error", place.normalized_error}},
             Verdict::Fail,
             {Interval{place.z_start_mm, place.z_end_mm}, {}, {}, {}}});
    }
    // |E_n| <= 1, said in micrometres: the difference against both uncertainties together.
    const ComparedError& worst = places.front();
    answer.value = std::abs(worst.measured_um - worst.predicted_um);
    const double both_um = std::hypot(worst.measured_uncertainty_um, worst.predicted_uncertainty_um);
    answer.upper_limit = std::round(100 * both_um) / 100;
    answer.unit = micrometre;
    answer.decimals = 1;
    const bool is_out = copy && copy->verdict == Verdict::Fail;
    answer.verdict = disagreeing == 0 && !is_out ? Verdict::Pass : Verdict::Fail;
    if (disagreeing == 0 && !is_out && copy && copy->verdict == Verdict::Undecided) answer.verdict = Verdict::Undecided;
    answer.verdict_words = disagreeing > 0 ? LT_TEXT("Engine", "✗ prediction disagrees with the copy")
                           : is_out        ? LT_TEXT("Engine", "✗ predicted well, but the copy is out of its limit")
                           : answer.verdict == Verdict::Undecided
                               ? LT_TEXT("Engine", "? predicted well; the copy's limit is not decided")
                               : LT_TEXT("Engine", "✓ prediction agrees with the copy");
    answer.sentence = LT_TEXT("Engine", "|E_n| {error:2} · {agreeing} of {rows} rows agree within both uncertainties.");
    const auto rows = static_cast<std::int64_t>(places.size());
    answer.values = {{"error", size(worst)}, {"agreeing", rows - disagreeing}, {"rows", rows}};
    return answer;
}

report::Plot proofPlot(const Proof& proof)
{
    report::Plot plot = errorsPlot(proof.predicted, proof.places);
    report::Curve along;
    along.name = LT_TEXT("Engine", "copy along z, ± U");
    along.colour = report::ColourRole::Mark;
    for (const MeasuredPlace& place : proof.along) {
        // A bar of ± U at each place; followed by a gap.
        for (const double error_um : {place.error_um - place.uncertainty_um, place.error_um + place.uncertainty_um}) {
            along.x.push_back(place.z_mm);
            along.y.push_back(error_um);
        }
        along.x.push_back(place.z_mm);
        along.y.push_back(notANumber);
    }
    if (!along.x.empty()) plot.curves.push_back(std::move(along));
    return plot;
}

report::Table proofTable(const Proof& proof)
{
    report::Table table{
        LT_TEXT("Engine", "Predicted and measured error of the diameter"),
        {LT_TEXT("Engine", "Row"), LT_TEXT("Engine", "From z [mm]"), LT_TEXT("Engine", "To z [mm]"),
         LT_TEXT("Engine", "Predicted [µm]"), LT_TEXT("Engine", "U [µm]"), LT_TEXT("Engine", "Measured [µm]"),
         LT_TEXT("Engine", "U [µm]"), LT_TEXT("Engine", "E_n"), LT_TEXT("Engine", "Agreement")},
        {},
        {0, 1, 1, 1, 1, 1, 1, 2, 0}};
    for (const ComparedError& place : proof.places)
        table.rows.push_back(
            {place.row, place.z_start_mm, place.z_end_mm, place.predicted_um, place.predicted_uncertainty_um,
             place.measured_um, place.measured_uncertainty_um, place.normalized_error,
             std::abs(place.normalized_error) <= 1 ? LT_TEXT("Engine", "✓ agrees") : LT_TEXT("Engine", "✗ disagrees")});
    return table;
}

}  // namespace lathelier::chain
