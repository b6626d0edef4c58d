#include "engine/stability/marks_item.h"

#include <cmath>

namespace lathelier::stability {
namespace {

std::optional<double> numberOf(const Values& values, const char* key)
{
    const Value* const value = find(values, key);
    const auto* number = value ? std::get_if<double>(value) : nullptr;
    if (number && std::isfinite(*number)) return *number;
    const auto* whole = value ? std::get_if<std::int64_t>(value) : nullptr;  // integers are possible in project files
    return whole ? std::optional(static_cast<double>(*whole)) : std::nullopt;
}

report::Limit lineAt(const SurfaceMarks& marks, const Language& language)
{
    return {report::Limit::Direction::Vertical, marks.speed_rpm,
            fill(text(LT_TEXT("Engine", "marks {frequency} Hz"), language),
                 {{"frequency", fixed(marks.frequency_hz, 1, language)}}, language)};
}

}  // namespace

Values toValues(const SurfaceMarks& marks)
{
    return {{"picture", marks.picture},
            {"speed_rpm", marks.speed_rpm},
            {"frequency_hz", marks.frequency_hz},
            {"uncertainty_hz", marks.uncertainty_hz},
            {"nearest_other_hz", marks.nearest_other_hz ? Value(*marks.nearest_other_hz) : Value()}};
}

std::optional<SurfaceMarks> marksOf(const Values& values)
{
    SurfaceMarks marks;
    const auto speed = numberOf(values, "speed_rpm"), frequency = numberOf(values, "frequency_hz");
    if (!speed || !frequency || *speed <= 0 || *frequency <= 0) return std::nullopt;
    marks.speed_rpm = *speed;
    marks.frequency_hz = *frequency;
    marks.uncertainty_hz = std::max(0.0, numberOf(values, "uncertainty_hz").value_or(0));
    marks.nearest_other_hz = numberOf(values, "nearest_other_hz");
    const Value* const picture = find(values, "picture");
    if (const auto* name = picture ? std::get_if<std::string>(picture) : nullptr) marks.picture = *name;
    return marks;
}

std::optional<ModelCheck> checkModel(const SurfaceMarks& marks, const LobeResult& lobes)
{
    if (marks.speed_rpm < lobes.speed_rpm.from || marks.speed_rpm > lobes.speed_rpm.to) return std::nullopt;
    const double model_hz = pointStabilityAt(lobes, marks.speed_rpm, 0).frequency_hz;
    if (!(model_hz > 0)) return std::nullopt;
    const double percent = 100 * (marks.frequency_hz / model_hz - 1);
    return ModelCheck{model_hz, percent, std::abs(percent) <= modelTolerance_percent};
}

report::Finding modelFinding(const SurfaceMarks& marks, const ModelCheck& check, const Language& language)
{
    report::Finding finding;
    finding.values = {{"marks", fixed(marks.frequency_hz, 1, language)},
                      {"uncertainty", fixed(2 * marks.uncertainty_hz, 1, language)},
                      {"model", fixed(check.model_hz, 1, language)},
                      {"percent", fixed(std::abs(check.difference_percent), 1, language)}};
    if (!check.agrees)
        finding.pattern = LT_TEXT("Engine",
                                  "Your marks say {marks} ± {uncertainty} Hz, your model says {model} Hz: {percent} % "
                                  "apart. Frequency response, diameter, speed or number of waves may be wrong.");
    else if (marks.nearest_other_hz) {
        finding.pattern = LT_TEXT("Engine",
                                  "Your marks say {marks} ± {uncertainty} Hz, your model says {model} Hz; the nearest "
                                  "other reading is {other} Hz away.");
        finding.values.emplace_back("other", fixed(*marks.nearest_other_hz, 1, language));
    } else {
        finding.pattern = LT_TEXT("Engine", "Your marks say {marks} ± {uncertainty} Hz, your model says {model} Hz.");
    }
    return finding;
}

void drawMarks(report::Plot& lobes, const SurfaceMarks& marks, const Language& language)
{
    lobes.limits.push_back(lineAt(marks, language));
}

void drawMarksFrequency(report::Plot& frequencies, const SurfaceMarks& marks, const Language& language)
{
    frequencies.limits.push_back(lineAt(marks, language));
    frequencies.limits.back().name = report::Caption{};
    frequencies.marks.push_back({marks.speed_rpm, marks.frequency_hz, lineAt(marks, language).name});
}

}  // namespace lathelier::stability
