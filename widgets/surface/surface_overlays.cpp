#include "widgets/surface/surface_overlays.h"

#include <QCoreApplication>
#include <cmath>

#include "engine/core/units.h"
#include "engine/surface/surface_plots.h"
#include "engine/surface/surface_report.h"
#include "widgets/core/language.h"

namespace lathelier::surface_panel {
namespace {

struct Overlays {
    Q_DECLARE_TR_FUNCTIONS(lathelier::surface_panel::Overlays)
};

constexpr int feedSeries = 0, chatterSeries = 1, lineSeries = 3;  // of the palette
constexpr double chatterWidth = 2;

QString length(const surface::ImageMarks& image, double pixels, int decimals)
{
    return image.mm_per_px ? screenQuantity(pixels * *image.mm_per_px, unit::mm, decimals)
                           : QStringLiteral("%1 px").arg(screenNumber(pixels, 1));
}

}  // namespace

Overlay feedOverlay(const surface::ImageMarks& image, const ShownImage& shown)
{
    Overlay overlay;
    overlay.name = Overlays::tr("feed marks, %1 apart").arg(length(image, image.feed_marks->pitch_px, 4));
    overlay.colour = feedSeries;
    overlay.stripes = shown.feed_stripes;
    overlay.spacing_px = 1 / surface::length(*image.view.feed);
    return overlay;
}

Overlay chatterOverlay(const surface::ImageMarks& image, const ShownImage& shown)
{
    const surface::ChatterMarks& chatter = *image.chatter_marks;
    Overlay overlay;
    overlay.name = chatter.axial_period_mm ? Overlays::tr("chatter marks, along the axis every %1")
                                                 .arg(screenQuantity(*chatter.axial_period_mm, unit::mm, 3))
                                           : Overlays::tr("chatter marks");
    overlay.colour = chatterSeries;
    overlay.stripes = shown.chatter_bands;
    overlay.spacing_px = 1 / surface::length(*image.view.bands);
    overlay.width = chatterWidth;
    return overlay;
}

Overlay lineOverlay(const surface::ImageMarks& image, int line)
{
    const surface::SurfaceView& view = image.view;
    const surface::NamedLine& named = view.lines[static_cast<std::size_t>(line)];
    Overlay overlay;
    overlay.name = Overlays::tr("line %1 of the spectrum").arg(QString::fromStdString(nameOf(named)));
    overlay.colour = lineSeries;
    overlay.stripes =
        surface::stripesOf(named.frequency, phaseOf(view.flat, named.frequency), view.flat.columns, view.flat.rows);
    overlay.spacing_px = 1 / surface::length(named.frequency);
    overlay.width = chatterWidth;
    return overlay;
}

std::vector<Ruler> rulersOf(const surface::ImageMarks& image, const surface::SurfaceParameters& parameters)
{
    if (!image.feed_marks || !image.view.feed) return {};
    std::vector<Ruler> rulers;
    rulers.push_back({Overlays::tr("found: %1").arg(length(image, image.feed_marks->pitch_px, 4)), feedSeries,
                      1 / surface::length(*image.view.feed)});
    if (parameters.feed_mm_rev && image.mm_per_px)
        rulers.push_back({Overlays::tr("feed: %1").arg(screenQuantity(*parameters.feed_mm_rev, unit::mm, 4)),
                          report::ColourRole::Limit,
                          *parameters.feed_mm_rev / (*image.mm_per_px * image.view.px_per_px)});
    return rulers;
}

double rulerDirection_deg(const surface::ImageMarks& image)
{
    return image.view.feed ? surface::angle_deg(*image.view.feed) : 0;
}

QString foundWords(const ShownOutcome& outcome)
{
    if (outcome.asks()) return {};
    const surface::ImageMarks& image = outcome.first();
    const Language language = screenLanguage();
    const report::Answer answer = surface::answer(image, language);
    QString words =
        Overlays::tr("The evaluation says: %1").arg(QString::fromStdString(text(answer.verdict_words, language)));
    if (image.chatter_marks && image.chatter_marks->frequency_hz)
        words += QStringLiteral(", %1 ± %2")
                     .arg(screenNumber(*image.chatter_marks->frequency_hz, 1),
                          screenQuantity(2 * image.chatter_marks->frequency_uncertainty_hz.value_or(0), unit::hz, 1));
    return words + "\n" + QString::fromStdString(sentenceText(answer, language));
}

}  // namespace lathelier::surface_panel
