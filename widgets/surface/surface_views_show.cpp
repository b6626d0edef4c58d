// What each of the views shows of a picture.
#include "engine/surface/surface_plots.h"
#include "engine/surface/surface_report.h"
#include "engine/surface/surface_words.h"
#include "engine/surface/task/next_speed.h"
#include "engine/surface/task/surface_answer.h"
#include "widgets/core/language.h"
#include "widgets/surface/surface_overlays.h"
#include "widgets/surface/surface_views.h"

namespace lathelier::surface_panel {

void SurfaceViews::showMarks()
{
    const surface::ImageMarks* const image = marksShown();
    if (!image) return;
    const ShownImage& shown = outcome_->shown[static_cast<std::size_t>(chosen_)];
    const double mm_per_px = image->mm_per_px.value_or(0) * image->view.px_per_px;
    marks_->setPicture(shown.flat, mm_per_px);
    std::vector<Overlay> overlays;
    if (showFeed_->isChecked() && image->view.feed) overlays.push_back(feedOverlay(*image, shown));
    if (showChatter_->isChecked() && image->view.bands && !outcome_->asks())
        overlays.push_back(chatterOverlay(*image, shown));
    if (line_ >= 0) overlays.push_back(lineOverlay(*image, line_));
    marks_->setOverlays(std::move(overlays));
    marks_->setRulers(rulersOf(*image, outcome_->result->parameters), rulerDirection_deg(*image));
    unrolled_->setPicture(shown.evaluated, mm_per_px);
    unrolled_->setOverlays({});
}

void SurfaceViews::showSpectrum()
{
    const surface::ImageMarks* const image = marksShown();
    if (!image) return;
    report::Plot plot = ringedSpectrum(*image);
    spectrum_->setData(std::move(plot));
    plot::PointedOut out;
    if (line_ >= 0) {
        const surface::Vector at = image->view.lines[static_cast<std::size_t>(line_)].frequency;
        const double pixel = image->view.px_per_px * image->mm_per_px.value_or(1);
        out.place = QPointF(at.x / pixel, -at.y / pixel);
    }
    spectrum_->pointOut(std::move(out));
    lines_->setData(linesOverNoise(*image));
}

void SurfaceViews::showPhotograph()
{
    const ShownImage& shown = outcome_->shown[static_cast<std::size_t>(chosen_)];
    const surface::ImageMarks* const image = marksShown();
    const surface::SurfaceParameters p = parametersOf(outcome_->question, outcome_->shown.size());
    photograph_->setPicture(shown.photograph, image ? image->mm_per_px.value_or(0) : 0, p.diameter_mm);
    photograph_->setTools(!outcome_->question.make_picture);
    std::optional<QRectF> region;
    if (!p.roi.empty()) {
        const surface::Region& roi = p.roi[p.roi.size() == 1 ? 0 : static_cast<std::size_t>(chosen_)];
        const QRectF there(roi.x, roi.y, roi.width, roi.height);
        if (there != QRectF(shown.photograph.rect())) region = there;
    }
    photograph_->view()->setRegion(region);
    photograph_->view()->setArrow(image && image->feed_direction_deg ? image->feed_direction_deg
                                                                     : p.feed_direction_deg);
    photograph_->setAlike(outcome_->shown.size() > 1, outcome_->question.taken_alike);
}

void SurfaceViews::showComparison()
{
    if (outcome_->before.isNull()) return;
    const auto name = [&](std::size_t i) {
        const surface::ImageMarks& image = outcome_->result->images[i];
        const QString file = QString::fromStdString(outcome_->shown[i].name);
        return image.speed_rpm
                   ? QStringLiteral("%1 · %2").arg(file, screenQuantity(*image.speed_rpm, LT_TEXT("Engine", "rpm"), 0))
                   : file;
    };
    QString alignment;
    if (outcome_->isLaid())
        alignment = tr("Laid over each other where one place was clicked in both");
    else if (const auto sentence = alignmentSentence(*outcome_->result, screenLanguage()))
        alignment =
            QString::fromStdString(fill(text(sentence->pattern, screenLanguage()), sentence->values, screenLanguage()));
    comparison_->setNames(name(0), name(1), alignment);
    comparison_->setPictures(outcome_->before, outcome_->after, outcome_->common_mm_per_px);
}

void SurfaceViews::showWords()
{
    const Language language = screenLanguage();
    QString html;
    for (const report::Section& section : surface::words(*outcome_, language)) {
        html += "<h3>" + QString::fromStdString(captionText(section.title, language)).toHtmlEscaped() + "</h3>";
        for (const report::Block& block : section.blocks)
            if (const auto* sentence = std::get_if<report::Paragraph>(&block))
                html += "<p>" +
                        QString::fromStdString(fill(text(sentence->pattern, language), sentence->values, language))
                            .toHtmlEscaped() +
                        "</p>";
    }
    words_->setHtml(html);
}

void SurfaceViews::showTables()
{
    std::vector<std::string> names;
    for (const ShownImage& shown : outcome_->shown) names.push_back(shown.name);
    numbers_->setQuantities(surfaceNumbers(*outcome_->result, names, screenLanguage()));
    const report::Table speeds = nextSpeedTable(*outcome_);
    speeds_->setTable(speeds);
    tabs_->setTabVisible(1, !speeds.rows.empty());
}

void SurfaceViews::showGenerator()
{
    generator_->setVisible(outcome_->question.make_picture && !presenting_);
    if (!outcome_->question.make_picture) return;
    generator_->setQuestion(outcome_->question);
    generator_->setFound(outcome_->result ? foundWords(*outcome_) : screenText(*outcome_->refused));
}

}  // namespace lathelier::surface_panel
