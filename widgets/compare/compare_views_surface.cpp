// The part in the scene of a comparison: its surface, colours and pictures.
#include <QBuffer>

#include "engine/core/units.h"
#include "engine/registration/compare_plots.h"
#include "widgets/compare/compare_views_parts.h"
#include "widgets/compare/place_words.h"
#include "widgets/plot/colour_legend.h"

namespace lathelier::compare_panel {
namespace {

std::string pngOf(const QImage& image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes.toStdString();
}

/// Projects each point to the reference surface and displaces it by `factor` times its value.
std::shared_ptr<const std::vector<float>> exaggerated(const std::vector<float>& deviation_mm,
                                                      const std::vector<float>& values_mm, double factor)
{
    auto outward = std::make_shared<std::vector<float>>(deviation_mm.size());
    for (std::size_t i = 0; i < outward->size(); ++i)
        (*outward)[i] = static_cast<float>(factor) * values_mm[i] - deviation_mm[i];
    return outward;
}

}  // namespace

void CompareViews::showSurface()
{
    Parts& p = *parts_;
    if (!p.outcome) return;
    const registration::CompareResult& result = p.result();
    std::optional<scene::SceneAxis> axis;
    if (result.alignment.reference_axis)
        axis = scene::SceneAxis{result.alignment.reference_axis->point_mm, result.alignment.reference_axis->direction};
    p.scene->setLongAxis(axis);
    const bool deviation = p.deviation->isChecked();
    p.smooth->setEnabled(deviation);

    scene::SceneObject reference;
    reference.name = tr("Reference");
    reference.scan = ScanPtr(p.outcome->original, &p.outcome->original->file.scan);
    reference.colour = plot::toQt(report::colourOf(report::ColourRole::Original));
    reference.visible = !deviation;
    scene::SceneObject copy;
    copy.name = tr("Copy");
    copy.scan = ScanPtr(p.outcome->copy, &p.outcome->copy->file.scan);
    copy.scene_T_scan = result.alignment.reference_T_copy;
    copy.colour = plot::toQt(report::colourOf(report::ColourRole::Copy));
    if (deviation && p.smooth->isChecked()) copy.values = p.outcome->form.local_mean_mm;
    if (deviation && !copy.values)
        copy.values = std::shared_ptr<const std::vector<float>>(p.outcome->result, &result.deviation_mm);
    const double factor = p.factor->value();
    if (copy.values && !p.showsSkin()) copy.outward_mm = exaggerated(result.deviation_mm, *copy.values, factor);
    if (copy.values && p.shares())
        copy.values = std::make_shared<const std::vector<float>>(
            sharesOfLimits_percent(result.parameters, *copy.values, result.windows->z_mm));
    p.coloured = copy.values;
    p.coloured_by_share = copy.values && p.shares();
    copy.along_axis = p.outcome->form.along_axis;
    recolour(p.greenWithin());
    std::vector<scene::SceneObject> objects{reference, copy};
    if (p.showsSkin()) {
        objects.back().visible = false;
        objects.push_back(skin());
    }
    p.scene->setObjects(std::move(objects));
    // With a magnified error the wireframe of the original is shown.
    const bool exaggerates = copy.values && factor > 1;
    std::vector<scene::SceneFlag> flags;
    if (copy.values)
        for (const cad::CompareFlag& flag : flagsOf(*p.outcome)) {
            const auto ink =
                flag.verdict ? (*flag.verdict == Verdict::Pass ? report::ColourRole::Within : report::ColourRole::Limit)
                             : report::ColourRole::Neutral;
            flags.push_back({shownPlace_mm(*p.outcome, flag.reference_mm, p.showsSkin() ? factor : 0), flagWords(flag),
                             plot::toQt(report::colourOf(ink))});
        }
    p.scene->setFlags(std::move(flags));
    p.scene->setOutline(exaggerates ? cad::outlineOf(result) : std::vector<std::vector<Eigen::Vector3d>>());
    if (p.place) setPlace(p.place);  // it stands on the surface as drawn
}

/// The surface of the copy, closed and without the scanner's noise.
scene::SceneObject CompareViews::skin()
{
    Parts& p = *parts_;
    const std::shared_ptr<const Skin>& skin = p.outcome->form.skin;
    const double factor = p.factor->value();
    if (p.skin.skin != skin || p.skin.factor != factor)
        p.skin = {skin, factor,
                  std::make_shared<const Scan>(meshOf(*skin, factor, p.result().axis_T_reference->inverse()))};
    scene::SceneObject object;
    object.name = tr("Copy");
    object.scan = p.skin.mesh;
    object.values = std::shared_ptr<const std::vector<float>>(skin, &skin->values);
    if (!p.shares()) return object;
    std::vector<float> z_mm(skin->values.size());
    for (std::size_t i = 0; i < z_mm.size(); ++i)
        z_mm[i] = static_cast<float>(skin->stations[i / static_cast<std::size_t>(skin->angle_count)].z_mm);
    object.values =
        std::make_shared<const std::vector<float>>(sharesOfLimits_percent(p.result().parameters, skin->values, z_mm));
    return object;
}

void CompareViews::recolour(std::optional<double> tolerance_mm)
{
    report::DeviationColours colours{limit_mm(), tolerance_mm};
    colours.lower = parts_->chosen_lower_mm;
    if (parts_->shares()) colours = {registration::shareLimit_percent, tolerance_mm};
    parts_->scene->setScale(parts_->shares() ? report::Axis{LT_TEXT("Engine", "Share of the limits"), unit::percent}
                                             : report::Axis{LT_TEXT("Engine", "Deviation"), unit::mm});
    if (!tolerance_mm && parts_->smooth->isChecked()) {
        colours.steps = report::contourSteps;
        if (parts_->outcome) colours.marked = parts_->result().parameters.tolerance_mm;
    }
    parts_->map->setColours(colours);
    parts_->scene->setColours(colours);
    if (!parts_->outcome) return;
    // Counts the coloured values: local means, or single points. Not repeated when only the tolerance changes.
    const Parts::Counted now{parts_->coloured ? parts_->coloured
                                              : std::shared_ptr<const std::vector<float>>(
                                                    parts_->outcome->result, &parts_->result().deviation_mm),
                             colours.least(), colours.limit};
    if (parts_->counted == now) return;
    parts_->counted = now;
    const auto counts = plot::countsOf(*now.values, colours);
    parts_->scene->setCounts(counts);
    parts_->map->setCounts(counts);
}

std::vector<report::Picture> CompareViews::pictures()
{
    Parts& p = *parts_;
    std::vector<report::Picture> pictures;
    if (!p.outcome || !p.scene->canDraw()) return pictures;
    QToolButton* before = p.deviation->isChecked() ? p.deviation : p.overlay;
    const auto take = [&](const Text& title, scene::SceneViewpoint viewpoint) {
        const QImage image = p.scene->paperPicture(viewpoint);
        if (!image.isNull()) pictures.push_back({title, pngOf(image)});
    };
    p.deviation->setChecked(true);
    showSurface();
    take(LT_TEXT("Engine", "Deviation of the copy, oblique"), scene::SceneViewpoint::Oblique);
    take(LT_TEXT("Engine", "Deviation of the copy, from the side"), scene::SceneViewpoint::Side);
    p.overlay->setChecked(true);
    showSurface();
    take(LT_TEXT("Engine", "Original (blue) and copy (red), oblique"), scene::SceneViewpoint::Oblique);
    take(LT_TEXT("Engine", "Original (blue) and copy (red), from the side"), scene::SceneViewpoint::Side);
    before->setChecked(true);
    showSurface();
    return pictures;
}

}  // namespace lathelier::compare_panel
