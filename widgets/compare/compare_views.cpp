#include "widgets/compare/compare_views.h"

#include <QBuffer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/registration/compare_plots.h"
#include "widgets/compare/compare_views_parts.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

constexpr double leastTolerance_mm = 1e-4;  // that can be dragged to

std::string pngOf(const QImage& image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes.toStdString();
}

}  // namespace

CompareViews::CompareViews(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>())
{
    Parts& p = *parts_;
    p.scene = new SceneView;
    p.map = new MapView;
    p.meridian = new ChartView;
    p.histogram = new ChartView;
    p.zones = new ZoneTable;
    p.numbers = new StatisticsTable;
    p.tabs = new QTabWidget;
    p.tabs->setDocumentMode(true);
    p.map->setObjectName("map");
    p.meridian->setObjectName("meridian");
    p.histogram->setObjectName("histogram");
    p.scene->setObjectName("scene");

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    buildBar();
    p.rows = new QSplitter(Qt::Vertical);
    p.upper = new QSplitter;
    p.lower = new QSplitter;
    for (QSplitter* row : {p.upper, p.lower}) {
        row->setChildrenCollapsible(false);
        p.rows->addWidget(row);
    }
    p.rows->setChildrenCollapsible(false);
    p.upper->addWidget(p.scene);
    p.upper->addWidget(p.map);
    p.lower->addWidget(p.meridian);
    p.lower->addWidget(p.tabs);
    p.rows->setStretchFactor(0, 11);
    p.rows->setStretchFactor(1, 10);
    for (QSplitter* row : {p.upper, p.lower})
        for (int i = 0; i < 2; ++i) row->setStretchFactor(i, 1);
    layout->addWidget(p.rows, 1);

    connect(p.scene, &SceneView::pointPicked, this, [this](int object, qint64 point) {
        setPlace(placeOfPoint(*parts_->picture, static_cast<std::size_t>(point), object == 0));
    });
    connect(p.scene, &SceneView::surfacePicked, this, [this](int object, const PickedPlace& surface) {
        setPlace(placeOnMesh(*parts_->picture, surface, object == 0));
    });
    connect(p.map, &PlotCanvas::clicked, this, [this](double z, double angle) {
        if (parts_->hasAxis()) setPlace(placeOnSurface(*parts_->picture, z, std::clamp(angle, 0.0, 359.999)));
    });
    const auto pickZ = [this](double z) {
        const double angle = parts_->place && parts_->place->angle_deg ? *parts_->place->angle_deg : 90;
        if (parts_->hasAxis()) setPlace(placeOnSurface(*parts_->picture, z, angle));
    };
    connect(p.meridian, &PlotCanvas::clicked, this, [pickZ](double z, double) { pickZ(z); });
    connect(p.zones, &ZoneTable::zonePicked, this, pickZ);
    connect(p.scene, &SceneView::limitEdited, this, [this](double limit) { setLimit(limit); });
    connect(p.map, &MapView::limitEdited, this, [this](double limit) { setLimit(limit); });
    connect(p.histogram, &ChartView::handleMoved, this, [this](const QString&, double value, double, bool dropped) {
        const double tolerance_mm = std::max(std::abs(value), leastTolerance_mm);
        showTolerance(tolerance_mm);
        parts_->draggedTolerance = dropped ? std::nullopt : std::optional(tolerance_mm);
        emit toleranceDragged(tolerance_mm, dropped);
    });
    for (PlotCanvas* canvas :
         {static_cast<PlotCanvas*>(p.map), static_cast<PlotCanvas*>(p.meridian), static_cast<PlotCanvas*>(p.histogram)})
        connect(canvas, &PlotCanvas::notWritten, this, &CompareViews::notWritten);
    connect(p.scene, &SceneView::notWritten, this, &CompareViews::notWritten);
    retranslate();
    arrange();
}

CompareViews::~CompareViews() = default;

const std::optional<ComparePlace>& CompareViews::place() const
{
    return parts_->place;
}

double CompareViews::limit_mm() const
{
    if (parts_->chosenLimit) return *parts_->chosenLimit;
    return parts_->picture ? colourLimit_mm(parts_->result()) : 1;
}

void CompareViews::setPicture(const std::shared_ptr<const ComparePicture>& picture)
{
    Parts& p = *parts_;
    const bool sameScans = p.picture && p.picture->reference == picture->reference && p.picture->copy == picture->copy;
    const bool sameValues = sameScans && p.picture->local_mean_mm == picture->local_mean_mm;
    p.picture = picture;
    if (!sameScans) {
        p.chosenLimit.reset();
        p.chosenFactor.reset();
        p.place.reset();
    }
    p.synthetic->setVisible(picture->synthetic);
    arrange();
    showCharts();
    if (sameValues)
        recolour(p.tolerance());  // only the verdict is new: nothing has to be uploaded
    else
        showSurface();
    if (p.place && p.place->point)
        setPlace(placeOfPoint(*picture, *p.place->point));
    else if (p.place && p.place->surface)
        setPlace(placeOnMesh(*picture, *p.place->surface));
    else
        setPlace(p.place);
}

void CompareViews::showCharts()
{
    Parts& p = *parts_;
    const registration::CompareResult& result = p.result();
    p.numbers->setPicture(*p.picture);
    p.zones->setResult(result);
    p.histogram->setData(histogramPlot(result, screenLanguage(), limit_mm()));
    if (p.draggedTolerance) showTolerance(*p.draggedTolerance);
    if (!p.hasAxis()) return;
    const double factor = p.chosenFactor.value_or(magnification(result));
    {
        const QSignalBlocker quiet(p.factor);
        p.factor->setValue(factor);
    }
    p.meridian->setData(magnifiedMeridian(result, screenLanguage(), factor));
    p.map->setData(unrolledMap(result, p.tolerance().has_value()));
}

/// Both limits stand where the pointer holds one of them.
void CompareViews::showTolerance(double tolerance_mm)
{
    parts_->histogram->setHandle("lower", -tolerance_mm, 0);
    parts_->histogram->setHandle("upper", tolerance_mm, 0);
}

void CompareViews::showSurface()
{
    Parts& p = *parts_;
    if (!p.picture) return;
    const registration::CompareResult& result = p.result();
    std::optional<SceneAxis> axis;
    if (result.alignment.reference_axis)
        axis = SceneAxis{result.alignment.reference_axis->point_mm, result.alignment.reference_axis->direction};
    p.scene->setLongAxis(axis);
    const bool deviation = p.deviation->isChecked();
    p.smooth->setEnabled(deviation);

    SceneObject reference;
    reference.name = tr("Reference");
    reference.scan = ScanPtr(p.picture->reference, &p.picture->reference->file.scan);
    reference.colour = toQt(colourOf(ColourRole::Original));
    reference.visible = !deviation;
    SceneObject copy;
    copy.name = tr("Copy");
    copy.scan = ScanPtr(p.picture->copy, &p.picture->copy->file.scan);
    copy.scene_T_scan = result.alignment.reference_T_copy;
    copy.colour = toQt(colourOf(ColourRole::Copy));
    if (deviation && p.smooth->isChecked()) copy.values = p.picture->local_mean_mm;
    if (deviation && !copy.values)
        copy.values = std::shared_ptr<const std::vector<float>>(p.picture->result, &result.deviation_mm);
    copy.onSurface = copy.values != nullptr;
    recolour(p.tolerance());
    p.scene->setObjects({reference, copy});
}

void CompareViews::recolour(std::optional<double> tolerance_mm)
{
    const DeviationColours colours{limit_mm(), tolerance_mm};
    parts_->map->setColours(colours);
    parts_->scene->setColours(colours);
}

void CompareViews::setLimit(std::optional<double> limit_mm)
{
    parts_->chosenLimit = limit_mm;
    recolour(parts_->tolerance());
}

void CompareViews::setPlace(const std::optional<ComparePlace>& place)
{
    Parts& p = *parts_;
    p.place = place;
    if (!place) {
        p.scene->setMarker({});
        p.map->setMarker({});
        p.meridian->setMarker({});
        p.histogram->setMarker({});
        p.zones->markZ({});
        return;
    }
    p.scene->setMarker(place->reference_mm, describe(*place));
    const bool onMap = place->z_mm && place->angle_deg;
    p.map->setMarker(onMap ? std::optional(QPointF(*place->z_mm, *place->angle_deg)) : std::nullopt);
    p.meridian->setMarker(place->z_mm);
    p.histogram->setMarker(place->deviation_mm ? place->deviation_mm : place->local_mean_mm);
    p.zones->markZ(place->z_mm);
}

QString CompareViews::describe(const ComparePlace& place) const
{
    const auto signedLength = [](double value) { return (value > 0 ? "+" : "") + screenNumber(value, 3) + " mm"; };
    QStringList lines;
    lines << QString("X %1   Y %2   Z %3 mm")
                 .arg(screenNumber(place.reference_mm.x(), 3), screenNumber(place.reference_mm.y(), 3),
                      screenNumber(place.reference_mm.z(), 3));
    if (place.z_mm && place.angle_deg)
        lines << tr("along the axis %1 mm, angle %2°")
                     .arg(screenNumber(*place.z_mm, 2), screenNumber(*place.angle_deg, 1));
    if (place.deviation_mm)
        lines << tr("deviation %1").arg(signedLength(*place.deviation_mm));
    else if (place.point || place.surface)
        lines << tr("this point was left out");
    if (place.local_mean_mm) lines << tr("mean around it %1").arg(signedLength(*place.local_mean_mm));
    return lines.join('\n');
}

std::vector<Picture> CompareViews::pictures()
{
    Parts& p = *parts_;
    std::vector<Picture> pictures;
    if (!p.picture || !p.scene->canDraw()) return pictures;
    const int shown = p.viewGroup->checkedId();
    QToolButton* before = p.deviation->isChecked() ? p.deviation : p.overlay;
    if (!p.scene->isVisibleTo(this)) {
        p.views[All]->setChecked(true);
        arrange();
    }
    const auto take = [&](const Text& title, SceneViewpoint viewpoint) {
        const QImage image = p.scene->picture(viewpoint);
        if (!image.isNull()) pictures.push_back({title, pngOf(image)});
    };
    p.overlay->setChecked(true);
    showSurface();
    take(LT_TEXT("Engine", "Original (blue) and copy (red), oblique"), SceneViewpoint::Oblique);
    take(LT_TEXT("Engine", "Original (blue) and copy (red), from the side"), SceneViewpoint::Side);
    p.deviation->setChecked(true);
    showSurface();
    take(LT_TEXT("Engine", "Deviation of the copy, oblique"), SceneViewpoint::Oblique);
    take(LT_TEXT("Engine", "Deviation of the copy, from the side"), SceneViewpoint::Side);
    before->setChecked(true);
    showSurface();
    if (p.viewGroup->checkedId() != shown) {
        p.viewGroup->button(shown)->setChecked(true);
        arrange();
    }
    return pictures;
}

}  // namespace lathelier
