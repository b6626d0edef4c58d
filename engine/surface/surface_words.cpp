#include "engine/surface/surface_words.h"

#include <algorithm>
#include <cmath>

#include "engine/surface/surface_report.h"

namespace lathelier::surface {
namespace {

constexpr double aboutZero = 0.1;                      // |ν| below this: bands along the axis
constexpr double quarterFrom = 0.15, quarterTo = 0.4;  // |ν| between these: steep bands

report::Paragraph paragraph(Text pattern, Values values)
{
    return {pattern, std::move(values)};
}

report::Paragraph ofOne(const ImageMarks& image, bool is_before, const Language& language)
{
    Values values{{"rpm", image.speed_rpm ? fixed(*image.speed_rpm, 0, language) : "?"},
                  {"limit", fixed(100 * image.detection_limit_relative_to_feed.value_or(0), 1, language)}};
    if (image.verdict == MarksVerdict::NoPeriodicMarks)
        return paragraph(is_before ? LT_TEXT("Engine", "Before, {rpm} rpm: no periodic marks found.")
                                   : LT_TEXT("Engine", "After, {rpm} rpm: no periodic marks found."),
                         std::move(values));
    if (isOpen(image))
        return paragraph(is_before ? LT_TEXT("Engine", "Before, {rpm} rpm: whether there is chatter is open.")
                                   : LT_TEXT("Engine", "After, {rpm} rpm: whether there is chatter is open."),
                         std::move(values));
    if (!image.chatter_marks)
        return paragraph(
            is_before ? LT_TEXT("Engine", "Before, {rpm} rpm: no chatter marks above {limit} % of the feed marks.")
                      : LT_TEXT("Engine", "After, {rpm} rpm: no chatter marks above {limit} % of the feed marks."),
            std::move(values));
    const ChatterMarks& chatter = *image.chatter_marks;
    values.emplace_back("relative", fixed(chatter.relative_to_feed, 2, language));
    if (!chatter.frequency_hz)
        return paragraph(
            is_before
                ? LT_TEXT("Engine", "Before, {rpm} rpm: chatter marks, {relative} times as strong as the feed marks.")
                : LT_TEXT("Engine", "After, {rpm} rpm: chatter marks, {relative} times as strong as the feed marks."),
            std::move(values));
    values.emplace_back("frequency", fixed(*chatter.frequency_hz, 1, language));
    values.emplace_back("uncertainty", fixed(2 * *chatter.frequency_uncertainty_hz, 1, language));
    values.emplace_back("m", std::int64_t{chatter.m.value_or(0)});
    values.emplace_back("phase", fixed(chatter.phase_deg, 0, language));
    return paragraph(is_before
                         ? LT_TEXT("Engine",
                                   "Before, {rpm} rpm: marks of {frequency} ± {uncertainty} Hz (m = {m}, ε {phase}°), "
                                   "{relative} times as strong as the feed marks.")
                         : LT_TEXT("Engine",
                                   "After, {rpm} rpm: marks of {frequency} ± {uncertainty} Hz (m = {m}, ε {phase}°), "
                                   "{relative} times as strong as the feed marks."),
                     std::move(values));
}

}  // namespace

SpeedRelationCheck speedRelationCheckOf(const ChatterMarks& chatter)
{
    const double size = std::abs(chatter.nu);
    if (size < aboutZero) return SpeedRelationCheck::Published;
    return chatter.nu < 0 && size > quarterFrom && size < quarterTo ? SpeedRelationCheck::Exact
                                                                    : SpeedRelationCheck::Neither;
}

std::optional<report::Paragraph> speedRelationSentence(const ImageMarks& image, const SurfaceParameters& parameters,
                                                       const Language& language)
{
    if (!image.chatter_marks) return std::nullopt;
    if (!image.feed_direction_deg || parameters.cut_direction == CutDirection::Unknown) return std::nullopt;
    const ChatterMarks& chatter = *image.chatter_marks;
    Values values{{"nu", fixed(chatter.nu, 3, language)},
                  {"feeds", fixed(chatter.nu == 0 ? 0 : 1 / std::abs(chatter.nu), 1, language)}};
    switch (speedRelationCheckOf(chatter)) {
        case SpeedRelationCheck::Exact:
            return paragraph(
                LT_TEXT("Engine",
                        "By the rule N = 60 f/k chatter is worst at ν = 0 (bands along the axis), by the exact "
                        "relation near ν = -¼ (steep bands, axial period 4 f). Here ν = {nu}, axial period {feeds} f: "
                        "these marks speak for the exact relation."),
                std::move(values));
        case SpeedRelationCheck::Published:
            return paragraph(
                LT_TEXT("Engine",
                        "By the rule N = 60 f/k chatter is worst at ν = 0 (bands along the axis), by the exact "
                        "relation near ν = -¼ (steep bands, axial period 4 f). Here ν = {nu}: as the rule says, or a "
                        "forced vibration."),
                std::move(values));
        case SpeedRelationCheck::Neither: break;
    }
    return paragraph(
        LT_TEXT("Engine",
                "By the rule N = 60 f/k chatter is worst at ν = 0 (bands along the axis), by the exact relation near "
                "ν = -¼ (steep bands, axial period 4 f). Here ν = {nu}: this picture decides for neither."),
        std::move(values));
}

std::optional<report::Paragraph> originSentence(const ImageMarks& image, const Language& language)
{
    if (!image.chatter_marks) return std::nullopt;
    const ChatterMarks& chatter = *image.chatter_marks;
    Values values{{"nu", fixed(chatter.nu, 3, language)}, {"phase", fixed(chatter.phase_deg, 0, language)}};
    if (chatter.kind == ChatterKind::Forced)
        return paragraph(
            LT_TEXT("Engine",
                    "Forced or regenerative? ν = {nu}: a whole number of waves in a revolution, or more, speaks for a "
                    "forced vibration (out-of-round stock, jaws, bearings, gears)."),
            std::move(values));
    if (chatter.kind == ChatterKind::Regenerative)
        return paragraph(LT_TEXT("Engine",
                                 "Regenerative: ε = {phase}° lies between 180° and 360°, as chatter that feeds itself "
                                 "does."),
                         std::move(values));
    return paragraph(LT_TEXT("Engine",
                             "Forced or regenerative? ν = {nu}; its sign is open until the directions of feed and cut "
                             "are given."),
                     std::move(values));
}

std::optional<report::Paragraph> certaintySentence(const ImageMarks& image, const Language& language)
{
    if (!image.chatter_marks || !image.chatter_marks->frequency_hz) return std::nullopt;
    const ChatterMarks& chatter = *image.chatter_marks;
    std::string all;
    for (const double candidate : chatter.candidates_hz)
        all += (all.empty() ? "" : ", ") + fixed(candidate, 1, language);
    Values values{{"m", std::int64_t{chatter.m.value_or(0)}},
                  {"waves", fixed(chatter.waves_in_view.value_or(0), 1, language)},
                  {"measured", fixed(chatter.waves_measured.value_or(0), 2, language)},
                  {"all", all}};
    if (chatter.m_certain)
        return paragraph(LT_TEXT("Engine",
                                 "{waves} waves lie in the picture: it decides m = {m} by itself (measured "
                                 "{measured})."),
                         std::move(values));
    if (image.curved)
        return paragraph(LT_TEXT("Engine",
                                 "The part curves away across the picture and was not unrolled: ν is sure, m = {m} is "
                                 "not (measured {measured}). Candidates: {all} Hz. Let it be unrolled, or let a model "
                                 "choose."),
                         std::move(values));
    return paragraph(LT_TEXT("Engine",
                             "Only {waves} waves lie in the picture: ν is sure, m = {m} is not (measured {measured}). "
                             "Candidates: {all} Hz. Photograph the whole width of the part, or let a model choose."),
                     std::move(values));
}

report::Paragraph pictureLimits()
{
    return {LT_TEXT("Engine",
                    "A picture cannot tell heights: no roughness and no amplitude in µm are made from it, for its "
                    "contrast depends on the light far more than on the surface. Strengths are compared only between "
                    "pictures taken alike."),
            {}};
}

std::vector<report::Paragraph> beforeAndAfter(const SurfaceResult& result, const Language& language)
{
    if (result.images.size() < 2) return {};
    return {ofOne(result.images[0], true, language), ofOne(result.images[1], false, language)};
}

std::optional<report::Paragraph> alignmentSentence(const SurfaceResult& result, const Language& language)
{
    if (!result.comparison) return std::nullopt;
    Values values{{"response", fixed(result.comparison->registration_response, 2, language)}};
    if (result.comparison->registered)
        return paragraph(LT_TEXT("Engine", "One surface in both pictures (response {response} of phase correlation)."),
                         std::move(values));
    if (result.comparison->same_scale)
        return paragraph(
            LT_TEXT("Engine",
                    "Different surfaces (response {response}): aligned by scale and direction only, not registered."),
            std::move(values));
    return paragraph(LT_TEXT("Engine",
                             "Different surfaces (response {response}), scale not known: aligned by direction only, "
                             "not registered."),
                     std::move(values));
}

std::vector<WholeWaveSpeed> wholeWaveSpeeds(const ImageMarks& image)
{
    std::vector<WholeWaveSpeed> speeds;
    if (!image.chatter_marks || !image.chatter_marks->frequency_hz || !image.speed_rpm) return speeds;
    const double f = *image.chatter_marks->frequency_hz;
    const int above = static_cast<int>(std::floor(60 * f / *image.speed_rpm));
    for (int k = above + 2; k >= std::max(1, above - 1); --k) speeds.push_back({k, 60 * f / k});
    return speeds;
}

report::Table speedTable(const ImageMarks& image)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Speeds with whole waves in a revolution, N = 60 f_c / k");
    table.columns = {LT_TEXT("Engine", "Waves, k"),
                     report::Labelled{LT_TEXT("Engine", "Spindle speed"), LT_TEXT("Engine", "rpm")}};
    table.decimals = {0, 0};
    for (const WholeWaveSpeed& speed : wholeWaveSpeeds(image))
        table.rows.push_back({std::int64_t{speed.k}, speed.speed_rpm});
    return table;
}

std::vector<report::Section> surfaceWords(const SurfaceResult& result, const Language& language)
{
    std::vector<report::Section> sections;
    const ImageMarks& first = result.images.front();
    const auto beginSection = [&](Text title) { sections.push_back({title, {}}); };
    const auto append = [&](std::optional<report::Paragraph> paragraph) {
        if (paragraph) sections.back().blocks.emplace_back(*std::move(paragraph));
    };
    beginSection(LT_TEXT("Engine", "What is seen"));
    for (report::Paragraph& each : beforeAndAfter(result, language)) append(std::move(each));
    append(alignmentSentence(result, language));
    if (result.images.size() < 2) {
        const report::Answer answered = answer(first, language);
        append(report::Paragraph{answered.verdict_words, {}});
        append(report::Paragraph{answered.sentence, answered.values});
    }
    if (first.chatter_marks) {
        beginSection(LT_TEXT("Engine", "Which vibration"));
        append(certaintySentence(first, language));
        append(originSentence(first, language));
        append(speedRelationSentence(first, result.parameters, language));
        if (report::Table speeds = speedTable(first); !speeds.rows.empty())
            sections.back().blocks.emplace_back(std::move(speeds));
    }
    beginSection(LT_TEXT("Engine", "What a picture cannot say"));
    append(pictureLimits());
    return sections;
}

}  // namespace lathelier::surface
