#include "widgets/cylindricity/cylindricity_views.h"

#include <QVBoxLayout>
#include <cmath>

#include "engine/core/units.h"
#include "engine/form/cylinder/cylindricity_plots.h"
#include "engine/form/cylinder/cylindricity_report.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"

namespace lathelier::cylindricity_panel {
namespace {

/// Magnification of the error in the 3-D view: the zone takes an eighth of the radius at most.
double magnificationOf(const form::FittedCylinder& cylinder)
{
    return readableFactor(0.125 * cylinder.radius_mm * 1000 / std::max(cylinder.CYLt_um, 1e-6));
}

}  // namespace

CylindricityViews::CylindricityViews(QWidget* parent)
    : QWidget(parent),
      remark_(new QLabel),
      section_(new QToolButton),
      synthetic_(new QLabel),
      scene_(new scene::SceneView),
      map_(new plot::MapView),
      radius_(new plot::ChartView),
      axis_(new plot::ChartView),
      numbers_(new CopyTable),
      primaryViews_(new PrimaryViews)
{
    scene_->setObjectName("scene");
    map_->setObjectName("map");
    radius_->setObjectName("radius");
    axis_->setObjectName("axis");
    numbers_->setObjectName("numbers");
    remark_->setObjectName("remark");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* row = new FlowRow;
    row->addWidget(remark_);
    section_->setObjectName("roundnessOfSection");
    section_->setAutoRaise(true);
    section_->setEnabled(false);
    row->addWidget(section_);
    synthetic_->setFrameShape(QFrame::Box);
    synthetic_->setMargin(2);
    synthetic_->hide();
    row->setTrailing(synthetic_);
    layout->addLayout(row);
    primaryViews_->add("part", scene_);
    primaryViews_->add("map", map_);
    primaryViews_->add("radius", radius_);
    primaryViews_->add("axis", axis_);
    primaryViews_->add("tables", numbers_);
    layout->addWidget(primaryViews_, 1);

    connect(section_, &QToolButton::clicked, this, [this] {
        if (place_) emit sectionRequested(place_->x());
    });
    const auto placeOf = [this](const scene::PickedPlace& on) -> Eigen::Vector2d {
        const Eigen::Vector3d place = placeOn(skin_, on);
        const double angle_deg = std::atan2(place.y(), place.x()) * 180 / M_PI;
        return {place.z(), angle_deg < 0 ? angle_deg + 360 : angle_deg};
    };
    connect(scene_, &scene::SceneView::surfacePicked, this, [this, placeOf](int, const scene::PickedPlace& on) {
        const Eigen::Vector2d place = placeOf(on);
        markPlace(place.x(), place.y());
    });
    connect(scene_, &scene::SceneView::surfaceHovered, this, [this, placeOf](int, const scene::PickedPlace& on) {
        const Eigen::Vector2d place = placeOf(on);
        const double deviation_um = map_->data().at(place.x(), place.y());
        if (!std::isfinite(deviation_um)) return;
        scene_->setTag(
            screenQuantity(deviation_um, micrometre, 2, true),
            QString("z %1  ·  %2°").arg(screenQuantity(place.x(), millimetre, 1), screenNumber(place.y(), 0)));
    });
    connect(map_, &plot::PlotCanvas::clicked, this, &CylindricityViews::markPlace);
    for (plot::ChartView* chart : {radius_, axis_})
        connect(chart, &plot::PlotCanvas::clicked, this,
                [this](double z_mm, double) { markPlace(z_mm, place_ ? place_->y() : 90); });
    connect(scene_, &scene::SceneView::limitEdited, this,
            [this](double upper_mm, double lower_mm) { recolour(1000 * upper_mm, 1000 * lower_mm); });
    connect(map_, &plot::MapView::limitEdited, this, &CylindricityViews::recolour);
    for (plot::PlotCanvas* canvas : {static_cast<plot::PlotCanvas*>(map_), static_cast<plot::PlotCanvas*>(radius_),
                                     static_cast<plot::PlotCanvas*>(axis_)})
        connect(canvas, &plot::PlotCanvas::notWritten, this, &CylindricityViews::notWritten);
    connect(scene_, &scene::SceneView::notWritten, this, &CylindricityViews::notWritten);
    retranslate();
}

void CylindricityViews::setOutcome(const std::shared_ptr<const form::CylindricityOutcome>& outcome)
{
    const bool new_surface = !outcome_ || outcome_->surface != outcome->surface;
    outcome_ = outcome;
    if (new_surface) {
        place_.reset();
        showPart();
        recolour(colourLimit_um(*outcome->surface), 0);
    }
    showCharts();
    showPlace();
}

void CylindricityViews::showPart()
{
    const form::CylinderSurface& surface = *outcome_->surface;
    factor_ = magnificationOf(surface.cylinder);
    skin_ = skinOf(surface);
    scene::SceneObject part;
    part.name = tr("Part");
    part.scan = std::make_shared<const Scan>(meshOf(skin_, factor_, surface.axis_T_points.inverse()));
    part.values = std::make_shared<const std::vector<float>>(skin_.values);
    scene_->setLongAxis(scene::SceneAxis{surface.cylinder.axis_point_mm, surface.cylinder.axis_direction});
    scene_->setObjects({part});
    showMagnification();
}

void CylindricityViews::showMagnification()
{
    remark_->setText(tr("Error drawn × %1").arg(screenNumber(factor_, 0)));
}

Values CylindricityViews::view() const
{
    Values kept;
    if (std::vector<double> camera = scene_->view(); !camera.empty()) kept.emplace_back("camera", std::move(camera));
    return kept;
}

void CylindricityViews::restoreView(const Values& kept)
{
    if (const Value* camera = lathelier::find(kept, "camera"))
        if (const auto* numbers = std::get_if<std::vector<double>>(camera)) scene_->setView(*numbers);
}

void CylindricityViews::showCharts()
{
    const form::CylinderSurface& surface = *outcome_->surface;
    map_->setData(unrolledCylinder(surface));
    radius_->setData(radiusAlongAxis(surface, outcome_->result->parameters));
    axis_->setData(centresAlongAxis(surface));
    numbers_->setQuantities(cylindricityReport(*outcome_->result, nullptr, outcome_->sources.inputs, screenLanguage()));
    synthetic_->setVisible(outcome_->sources.synthetic);
}

void CylindricityViews::recolour(double upper_um, double lower_um)
{
    report::DeviationColours colours{upper_um};
    if (lower_um > 0) colours.lower = lower_um;
    map_->setColours(colours);
    colours.limit /= 1000;
    if (colours.lower) *colours.lower /= 1000;
    scene_->setColours(colours);
}

void CylindricityViews::markPlace(double z_mm, double angle_deg)
{
    if (!outcome_) return;
    place_ = QPointF(z_mm, std::clamp(angle_deg, 0.0, 359.999));
    showPlace();
}

void CylindricityViews::showPlace()
{
    section_->setEnabled(place_.has_value());
    if (!place_) {
        scene_->setMarker({});
        map_->setMarker({});
        for (plot::ChartView* chart : {radius_, axis_}) chart->setMarker({});
        return;
    }
    const double z_mm = place_->x(), angle_deg = place_->y();
    const double deviation_um = map_->data().at(z_mm, angle_deg);
    QStringList lines;
    if (std::isfinite(deviation_um)) lines << tr("deviation %1").arg(screenQuantity(deviation_um, micrometre, 2, true));
    lines << tr("along the axis %1, angle %2°").arg(screenQuantity(z_mm, millimetre, 2), screenNumber(angle_deg, 1));
    const Eigen::Isometry3d& axis_T_points = outcome_->surface->axis_T_points;
    const Eigen::Vector3d place = axis_T_points * placeOnCylinder(*outcome_->surface, z_mm, angle_deg);
    scene_->setMarker(axis_T_points.inverse() * displacedPlace(skin_, place, factor_), lines.join('\n'));
    map_->setMarker(place_);
    for (plot::ChartView* chart : {radius_, axis_}) chart->setMarker(z_mm);
}

void CylindricityViews::retranslate()
{
    primaryViews_->setTitle("part", tr("Part"));
    primaryViews_->setTitle("map", tr("Map"));
    primaryViews_->setTitle("radius", tr("Local radius"));
    primaryViews_->setTitle("axis", tr("Axis"));
    primaryViews_->setTitle("tables", tr("Numbers"));
    numbers_->setAccessibleName(tr("Numbers"));
    section_->setText(tr("Roundness of this section"));
    section_->setToolTip(tr("Cuts the marked section out of the points and opens it in the panel Roundness"));
    synthetic_->setText(tr("Synthetic data"));
    synthetic_->setToolTip(tr("These points were computed, not measured."));
    scene_->setScale({LT_TEXT("Engine", "Deviation"), unit::mm});
    if (!outcome_) return;
    showMagnification();
    showCharts();
    showPlace();
}

}  // namespace lathelier::cylindricity_panel
