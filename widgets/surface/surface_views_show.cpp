// What each of the views shows of a picture.
#include "engine/surface/surface_plots.h"
#include "engine/surface/surface_report.h"
#include "engine/surface/surface_words.h"
#include "widgets/core/language.h"
#include "widgets/surface/next_speed.h"
#include "widgets/surface/surface_answer.h"
#include "widgets/surface/surface_overlays.h"
#include "widgets/surface/surface_views.h"

namespace lathelier::surface_panel {

void SurfaceViews::showMarks()
{
    const surface::ImageMarks* const image = marksShown();
    if (!image) return;
    const ShownImage& shown = picture_->shown[static_cast<std::size_t>(chosen_)];
    const double mm_per_px = image->mm_per_px.value_or(0) * image->view.px_per_px;
    marks_->setPicture(shown.flat, mm_per_px);
    std::vector<Overlay> overlays;
    if (showFeed_->isChecked() && image->view.feed) overlays.push_back(feedOverlay(*image, shown));
    if (showChatter_->isChecked() && image->view.bands && !picture_->asks())
        overlays.push_back(chatterOverlay(*image, shown));
    if (line_ >= 0) overlays.push_back(lineOverlay(*image, line_));
    marks_->setOverlays(std::move(overlays));
    marks_->setRulers(rulersOf(*image, picture_->result->parameters), rulerDirection_deg(*image));
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
    const ShownImage& shown = picture_->shown[static_cast<std::size_t>(chosen_)];
    const surface::ImageMarks* const image = marksShown();
    const surface::SurfaceParameters p = parametersOf(picture_->question, picture_->shown.size());
    photograph_->setPicture(shown.photograph, image ? image->mm_per_px.value_or(0) : 0, p.diameter_mm);
    photograph_->setTools(!picture_->question.make_picture);
    std::optional<QRectF> region;
    if (!p.roi.empty()) {
        const surface::Region& roi = p.roi[p.roi.size() == 1 ? 0 : static_cast<std::size_t>(chosen_)];
        const QRectF there(roi.x, roi.y, roi.width, roi.height);
        if (there != QRectF(shown.photograph.rect())) region = there;
    }
    photograph_->view()->setRegion(region);
    photograph_->view()->setArrow(image && image->feed_direction_deg ? image->feed_direction_deg
                                                                     : p.feed_direction_deg);
    photograph_->setAlike(picture_->shown.size() > 1, picture_->question.taken_alike);
}

void SurfaceViews::showComparison()
{
    if (picture_->before.isNull()) return;
    const auto name = [&](std::size_t i) {
        const surface::ImageMarks& image = picture_->result->images[i];
        const QString file = QString::fromStdString(picture_->shown[i].name);
        return image.speed_rpm
                   ? QStringLiteral("%1 · %2").arg(file, screenQuantity(*image.speed_rpm, LT_TEXT("Engine", "rpm"), 0))
                   : file;
    };
    QString alignment;
    if (picture_->isLaid())
        alignment = tr("Laid over each other where one place was clicked in both");
    else if (const auto said = alignmentSentence(*picture_->result, screenLanguage()))
        alignment = QString::fromStdString(fill(text(said->pattern, screenLanguage()), said->values, screenLanguage()));
    comparison_->setNames(name(0), name(1), alignment);
    comparison_->setPictures(picture_->before, picture_->after, picture_->common_mm_per_px);
}

void SurfaceViews::showWords()
{
    const Language language = screenLanguage();
    QString html;
    for (const report::Section& section : surface_panel::words(*picture_, language)) {
        html += "<h3>" + QString::fromStdString(captionText(section.title, language)).toHtmlEscaped() + "</h3>";
        for (const report::Block& block : section.blocks)
            if (const auto* said = std::get_if<report::Paragraph>(&block))
                html += "<p>" +
                        QString::fromStdString(fill(text(said->pattern, language), said->values, language))
                            .toHtmlEscaped() +
                        "</p>";
    }
    words_->setHtml(html);
}

void SurfaceViews::showTables()
{
    std::vector<std::string> names;
    for (const ShownImage& shown : picture_->shown) names.push_back(shown.name);
    numbers_->setQuantities(surfaceNumbers(*picture_->result, names, screenLanguage()));
    const report::Table speeds = nextSpeedTable(*picture_);
    speeds_->setTable(speeds);
    tabs_->setTabVisible(1, !speeds.rows.empty());
}

void SurfaceViews::showGenerator()
{
    generator_->setVisible(picture_->question.make_picture && !presenting_);
    if (!picture_->question.make_picture) return;
    generator_->setQuestion(picture_->question);
    generator_->setFound(picture_->result ? foundWords(*picture_) : screenText(*picture_->refused));
}

}  // namespace lathelier::surface_panel
