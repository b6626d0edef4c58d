#include "engine/surface/surface_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/io/io_codes.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"
#include "engine/surface/surface_pictures.h"
#include "engine/surface/surface_plots.h"
#include "engine/surface/surface_quantities.h"
#include "engine/surface/surface_words.h"

namespace lathelier::surface {
namespace {

void addChatter(report::Answer& answer, const ImageMarks& image, const Language& language)
{
    const ChatterMarks& chatter = *image.chatter_marks;
    answer.verdict_words = LT_TEXT("Engine", "chatter marks");
    answer.values = {{"phase", fixed(chatter.phase_deg, 0, language)},
                     {"relative", fixed(chatter.relative_to_feed, 2, language)}};
    if (!chatter.frequency_hz) {
        answer.sentence = LT_TEXT("Engine",
                                  "{phase}° of a wave from one turn to the next; {relative} times as strong as "
                                  "the feed marks. Diameter, scale and speed give the frequency.");
        return;
    }
    answer.value = chatter.frequency_hz;
    answer.expanded_uncertainty = 2 * *chatter.frequency_uncertainty_hz;
    answer.unit = unit::hz;
    answer.decimals = 1;
    answer.values.emplace_back("waves", fixed(*chatter.m + chatter.nu, 2, language));
    answer.values.emplace_back("rpm", fixed(*image.speed_rpm, 0, language));
    std::string others;
    for (std::size_t i = 1; i < chatter.candidates_hz.size(); ++i)
        others += (i == 1 ? "" : ", ") + fixed(chatter.candidates_hz[i], 1, language);
    answer.values.emplace_back("others", others);
    if (chatter.kind == ChatterKind::Forced)
        answer.sentence = LT_TEXT("Engine",
                                  "{waves} waves in a turn at {rpm} rpm: forced or regenerative? A whole "
                                  "number of waves speaks for stock, jaws, bearings or gears.");
    else if (others.empty())
        answer.sentence =
            LT_TEXT("Engine", "{waves} waves in a turn at {rpm} rpm, {relative} times as strong as the feed marks.");
    else
        answer.sentence =
            LT_TEXT("Engine", "{waves} waves in a turn at {rpm} rpm. The picture leaves open: {others} Hz.");
}

std::vector<report::QuantityTable> tablesOf(const ImageMarks& image)
{
    std::vector<report::QuantityTable> tables;
    tables.push_back(
        report::quantityTable(LT_TEXT("Engine", "Picture"), image,
                              {"width", "height", "bits", "mm_per_px", "speed_rpm", "saturated_percent", "unrolled",
                               "threshold", "largest_significance", "detection_limit_relative_to_feed"}));
    if (image.feed_marks)
        tables.push_back(report::quantityTable(LT_TEXT("Engine", "Feed marks"), *image.feed_marks,
                                               {"pitch_mm", "pitch_px", "pitch_error_percent", "direction_deg",
                                                "significance", "regularity", "share_percent"}));
    if (image.chatter_marks)
        tables.push_back(report::quantityTable(LT_TEXT("Engine", "Chatter marks"), *image.chatter_marks,
                                               {"frequency_hz",
                                                "frequency_uncertainty_hz",
                                                "candidates_hz",
                                                "harmonic_of_hz",
                                                "nearest_other_hz",
                                                "m",
                                                "m_certain",
                                                "waves_measured",
                                                "waves_uncertainty",
                                                "waves_in_view",
                                                "nu",
                                                "phase_deg",
                                                "axial_period_mm",
                                                "circumferential_pitch_mm",
                                                "inclination_deg",
                                                "relative_to_feed",
                                                "significance",
                                                "regularity",
                                                "share_percent",
                                                "lines"}));
    return tables;
}

report::QuantityTable comparisonTable(const SurfaceComparison& comparison)
{
    return report::quantityTable(LT_TEXT("Engine", "Comparison"), comparison,
                                 {"same_scale", "registration_response", "registered"});
}

report::Section pictureSection(const ImageMarks& image, const SurfaceParameters& parameters, const Language& language)
{
    report::Section section{image.path, {answer(image, language)}};
    section.blocks.push_back(report::Picture{LT_TEXT("Engine", "Picture as evaluated"), picturePng(image)});
    section.blocks.push_back(report::Picture{LT_TEXT("Engine", "Picture without its uneven light"),
                                             markedPictureSvg(image, parameters, language)});
    section.blocks.push_back(ringedSpectrum(image));
    section.blocks.push_back(linesOverNoise(image));
    for (report::QuantityTable& table : tablesOf(image)) section.blocks.emplace_back(std::move(table));
    return section;
}

}  // namespace

report::Answer answer(const ImageMarks& image, const Language& language)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Marks of the surface");
    answer.subject = image.path;
    if (image.verdict == MarksVerdict::NoPeriodicMarks) {
        answer.verdict_words = LT_TEXT("Engine", "no periodic marks found");
        answer.sentence =
            LT_TEXT("Engine", "The strongest line is {largest} times the noise; {threshold} would be a mark.");
        answer.values = {{"largest", fixed(image.largest_significance, 1, language)},
                         {"threshold", fixed(image.threshold, 1, language)}};
        return answer;
    }
    if (image.chatter_marks) {
        addChatter(answer, image, language);
        return answer;
    }
    const bool is_open = isOpen(image);
    answer.verdict_words =
        is_open ? LT_TEXT("Engine", "feed marks, chatter undecided") : LT_TEXT("Engine", "feed marks");
    answer.sentence =
        is_open ? (image.feed_marks->pitch_mm
                       ? LT_TEXT("Engine", "Feed marks {pitch} mm apart; whether there is chatter is open.")
                       : LT_TEXT("Engine", "Feed marks {pitch} px apart; whether there is chatter is open."))
        : image.feed_marks->pitch_mm
            ? LT_TEXT("Engine", "Feed marks {pitch} mm apart, no chatter marks above {limit} % of the feed line.")
            : LT_TEXT("Engine", "Feed marks {pitch} px apart, no chatter marks above {limit} % of the feed line.");
    answer.values = {{"pitch", fixed(image.feed_marks->pitch_mm.value_or(image.feed_marks->pitch_px),
                                     image.feed_marks->pitch_mm ? 4 : 2, language)},
                     {"limit", fixed(100 * *image.detection_limit_relative_to_feed, 1, language)}};
    return answer;
}

report::Section surfaceSummary(const SurfaceResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {}};
    for (const ImageMarks& image : result.images) section.blocks.push_back(answer(image, language));
    if (result.comparison) section.blocks.emplace_back(comparisonTable(*result.comparison));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document surfaceNumbers(const SurfaceResult& result, const std::vector<std::string>& names,
                                const Language& language)
{
    report::Document document;
    report::Section& all = document.sections.emplace_back();
    for (std::size_t i = 0; i < result.images.size(); ++i)
        for (report::QuantityTable& table : tablesOf(result.images[i])) {
            if (names.size() > 1) table.title = names.at(i) + " · " + report::captionText(table.title, language);
            all.blocks.emplace_back(std::move(table));
        }
    if (result.comparison) all.blocks.emplace_back(comparisonTable(*result.comparison));
    return document;
}

report::Document surfaceReport(const SurfaceResult& result, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Marks of turned surfaces");
    document.synthetic = contains(result.notes, notes::syntheticData);
    document.sections.push_back(surfaceSummary(result, language));
    std::vector<report::Section> words = surfaceWords(result, language);
    if (result.images.size() > 1)
        words.front().blocks.emplace_back(
            report::Picture{LT_TEXT("Engine", "Before and after, in one scale, direction and grey"),
                            comparisonSvg(result, {result.images[0].path, result.images[1].path}, language)});
    std::move(words.begin(), words.end(), std::back_inserter(document.sections));
    for (const ImageMarks& image : result.images)
        document.sections.push_back(pictureSection(image, result.parameters, language));
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{
              LT_TEXT(
                  "Engine",
                  "The picture is divided by its local mean and spread; lines of its spectrum count when their power "
                  "exceeds the level of the noise along rows and columns by the threshold. The feed marks are the comb "
                  "at 1/f, and give the direction of the axis; the chatter marks are a lattice of lines beside it, "
                  "whose "
                  "wave vector gives the frequency f_c = n (πD k_y + f k_z). Heights cannot be told from a picture."),
              {}},
          report::parametersTable(result.parameters, language)}});
    return document;
}

}  // namespace lathelier::surface
