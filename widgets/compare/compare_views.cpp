#include "widgets/compare/compare_views.h"

#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/registration/compare_plots.h"
#include "widgets/compare/compare_views_parts.h"
#include "widgets/compare/place_words.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/view_frame.h"
#include "widgets/plot/colour_legend.h"

namespace lathelier::compare_panel {
namespace {

constexpr int skinObject = 2;               // in the scene, behind the original and the copy
constexpr double leastTolerance_mm = 1e-4;  // least tolerance reachable by dragging

}  // namespace

CompareViews::CompareViews(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>())
{
    Parts& p = *parts_;
    p.scene = new scene::SceneView;
    p.map = new plot::MapView;
    p.along = new plot::ChartView;
    p.meridian = new plot::ChartView;
    p.histogram = new plot::ChartView;
    p.zones = new ZoneTable;
    p.numbers = new StatisticsTable;
    p.tabs = new QTabWidget;
    p.tabs->setDocumentMode(true);
    p.map->setObjectName("map");
    p.along->setObjectName("along");
    p.meridian->setObjectName("meridian");
    p.histogram->setObjectName("histogram");
    p.scene->setObjectName("scene");

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    buildBar();
    auto* part = new QSplitter(Qt::Vertical);
    part->setChildrenCollapsible(false);
    part->addWidget(p.scene);
    part->addWidget(p.along);
    part->setStretchFactor(0, 3);
    part->setStretchFactor(1, 2);
    p.tabs->addTab(p.numbers, QString());
    p.primary_views = new PrimaryViews;
    p.primary_views->add(view::part, part);
    p.primary_views->add(view::map, p.map);
    p.primary_views->add(view::meridian, p.meridian);
    p.primary_views->add(view::distribution, p.histogram);
    p.sizes = new SizeTable;
    p.primary_views->add(view::sizes, p.sizes);
    p.primary_views->setAvailable(view::sizes, false);
    p.primary_views->add(view::tables, p.tabs);
    p.trend = new plot::ChartView;
    p.trend->setObjectName("trend");
    p.copy_table = new CopyTable;
    p.copy_table->setObjectName("copies");
    p.copy_table->setProperty(ViewFrame::onlyLarge, true);  // hidden when small, in favour of the trend
    p.copies = new QSplitter(Qt::Vertical);
    p.copies->setChildrenCollapsible(false);
    p.copies->addWidget(p.trend);
    p.copies->addWidget(p.copy_table);
    p.primary_views->add(view::copies, p.copies);
    p.primary_views->setAvailable(view::copies, false);
    connect(p.copy_table, &QTableWidget::cellDoubleClicked, this, [this](int row, int) {
        if (row > 0) emit copyRequested(row - 1);
    });
    layout->addWidget(p.primary_views, 1);

    connect(p.scene, &scene::SceneView::pointPicked, this, [this](int object, qint64 point) {
        setPlace(placeOfPoint(*parts_->outcome, static_cast<std::size_t>(point), object == 0));
    });
    connect(p.scene, &scene::SceneView::surfacePicked, this,
            [this](int object, const scene::PickedPlace& surface) { setPlace(placeOf(object, surface)); });
    connect(p.scene, &scene::SceneView::pointHovered, this, [this](int object, qint64 point) {
        tag(placeOfPoint(*parts_->outcome, static_cast<std::size_t>(point), object == 0));
    });
    connect(p.scene, &scene::SceneView::surfaceHovered, this,
            [this](int object, const scene::PickedPlace& surface) { tag(placeOf(object, surface)); });
    connect(p.map, &plot::PlotCanvas::clicked, this, [this](double z, double angle) {
        if (parts_->hasAxis()) setPlace(placeOnSurface(*parts_->outcome, z, std::clamp(angle, 0.0, 359.999)));
    });
    const auto pickZ = [this](double z) {
        const double angle = parts_->place && parts_->place->angle_deg ? *parts_->place->angle_deg : 90;
        if (parts_->hasAxis()) setPlace(placeOnSurface(*parts_->outcome, z, angle));
    };
    for (plot::ChartView* chart : {p.along, p.meridian})
        connect(chart, &plot::PlotCanvas::clicked, this, [pickZ](double z, double) { pickZ(z); });
    connect(p.zones, &ZoneTable::zonePicked, this, pickZ);
    connect(p.sizes, &SizeTable::sizePicked, this, pickZ);
    connect(p.scene, &scene::SceneView::limitEdited, this,
            [this](double upper, double lower) { setLimit(upper, lower > 0 ? std::optional(lower) : std::nullopt); });
    connect(p.map, &plot::MapView::limitEdited, this,
            [this](double upper, double lower) { setLimit(upper, lower > 0 ? std::optional(lower) : std::nullopt); });
    connect(p.histogram, &plot::ChartView::handleMoved, this,
            [this](const QString&, double value, double, bool dropped) {
                const double tolerance_mm = std::max(std::abs(value), leastTolerance_mm);
                showTolerance(tolerance_mm);
                parts_->dragged_tolerance_mm = dropped ? std::nullopt : std::optional(tolerance_mm);
                emit toleranceDragged(tolerance_mm, dropped);
            });
    for (plot::PlotCanvas* canvas :
         {static_cast<plot::PlotCanvas*>(p.map), static_cast<plot::PlotCanvas*>(p.along),
          static_cast<plot::PlotCanvas*>(p.meridian), static_cast<plot::PlotCanvas*>(p.histogram)})
        connect(canvas, &plot::PlotCanvas::notWritten, this, &CompareViews::notWritten);
    connect(p.scene, &scene::SceneView::notWritten, this, &CompareViews::notWritten);
    retranslate();
    arrange();
}

CompareViews::~CompareViews() = default;

void CompareViews::markAlong(double z_mm, std::optional<double> angle_deg)
{
    if (parts_->hasAxis()) setPlace(placeOnSurface(*parts_->outcome, z_mm, angle_deg.value_or(90)));
}

PrimaryViews* CompareViews::primaryViews() const
{
    return parts_->primary_views;
}

/// Of a mesh in the scene: the original, the copy or the skin.
cad::ComparePlace CompareViews::placeOf(int object, const scene::PickedPlace& surface) const
{
    const cad::CompareOutcome& outcome = *parts_->outcome;
    return object == skinObject ? placeOnSkin(outcome, surface) : placeOnMesh(outcome, surface, object == 0);
}

const std::optional<cad::ComparePlace>& CompareViews::place() const
{
    return parts_->place;
}

double CompareViews::limit_mm() const
{
    if (parts_->chosen_limit_mm) return *parts_->chosen_limit_mm;
    return parts_->outcome ? colourLimit_mm(parts_->result(), parts_->greenWithin().has_value()) : 1;
}

void CompareViews::setOutcome(const std::shared_ptr<const cad::CompareOutcome>& outcome)
{
    Parts& p = *parts_;
    const bool sameScans = p.outcome && p.outcome->original == outcome->original && p.outcome->copy == outcome->copy;
    const bool sameValues = sameScans && p.outcome->form.local_mean_mm == outcome->form.local_mean_mm;
    p.outcome = outcome;
    if (!sameScans && !p.restored) {
        p.chosen_limit_mm.reset();
        p.chosen_lower_mm.reset();
        p.chosen_factor.reset();
    }
    if (!sameScans) p.place.reset();
    p.restored = false;
    p.synthetic->setVisible(outcome->sources.synthetic);
    arrange();
    showCharts();
    if (sameValues && !p.shares() && !p.coloured_by_share)
        recolour(p.greenWithin());  // only the verdict changed: no upload of geometry
    else
        showSurface();
    if (p.place && p.place->point)
        setPlace(placeOfPoint(*outcome, *p.place->point));
    else if (p.place && p.place->surface)
        setPlace(placeOnMesh(*outcome, *p.place->surface));
    else
        setPlace(p.place);
}

void CompareViews::setCopies(const std::vector<registration::CopySummary>& copies)
{
    Parts& p = *parts_;
    p.summaries = copies;
    const bool several = copies.size() > 1;
    p.primary_views->setAvailable(view::copies, several);
    if (!several || !p.outcome) return;
    p.trend->setData(copiesTrend(copies, p.result().parameters, screenLanguage()));
    p.copy_table->setTable(copiesTable(copies, screenLanguage()));
    p.copy_table->item(0, 0)->setText(p.copy_table->item(0, 0)->text() + " ◀");  // marks the copy on screen
}

Values CompareViews::view() const
{
    const Parts& p = *parts_;
    Values kept{{"colours", std::string(p.pass_fail->isChecked() ? "pass_fail" : "form")},
                {"surface", std::string(p.overlay->isChecked() ? "overlay" : "deviation")},
                {"local_mean", p.smooth->isChecked()},
                {"scale_limit_mm", p.chosen_limit_mm ? Value(*p.chosen_limit_mm) : Value()},
                {"scale_lower_mm", p.chosen_lower_mm ? Value(*p.chosen_lower_mm) : Value()},
                {"magnification", p.chosen_factor ? Value(*p.chosen_factor) : Value()}};
    if (std::vector<double> camera = p.scene->view(); !camera.empty()) kept.emplace_back("camera", std::move(camera));
    return kept;
}

void CompareViews::restoreView(const Values& kept)
{
    Parts& p = *parts_;
    const auto is = [&kept](const char* key, const Value& value) {
        const Value* const there = lathelier::find(kept, key);
        return there && *there == value;
    };
    const auto number = [&kept](const char* key) -> std::optional<double> {
        const Value* const there = lathelier::find(kept, key);
        const auto* const given = there ? std::get_if<double>(there) : nullptr;
        return given && *given > 0 ? std::optional(*given) : std::nullopt;
    };
    const QSignalBlocker quiet[]{QSignalBlocker(p.pass_fail), QSignalBlocker(p.form), QSignalBlocker(p.overlay),
                                 QSignalBlocker(p.deviation), QSignalBlocker(p.smooth)};
    (is("colours", std::string("pass_fail")) ? p.pass_fail : p.form)->setChecked(true);
    (is("surface", std::string("overlay")) ? p.overlay : p.deviation)->setChecked(true);
    p.smooth->setChecked(!is("local_mean", false));
    p.chosen_limit_mm = number("scale_limit_mm");
    p.chosen_lower_mm = number("scale_lower_mm");
    p.chosen_factor = number("magnification");
    p.restored = true;
    if (const Value* camera = lathelier::find(kept, "camera"))
        if (const auto* numbers = std::get_if<std::vector<double>>(camera)) p.scene->setView(*numbers);
    if (p.outcome) setOutcome(p.outcome);
}

void CompareViews::showCharts()
{
    Parts& p = *parts_;
    const registration::CompareResult& result = p.result();
    if (p.hasAxis()) {
        const QSignalBlocker quiet(p.factor);
        p.factor->setValue(p.chosen_factor.value_or(magnification(result)));
    }
    p.numbers->setOutcome(*p.outcome);
    p.zones->setResult(result);
    p.primary_views->setAvailable(view::sizes, p.outcome->sizes != nullptr);
    if (p.outcome->sizes) p.sizes->setSizes(*p.outcome->sizes);
    p.histogram->setData(histogramPlot(result, screenLanguage(), limit_mm()));
    if (p.dragged_tolerance_mm) showTolerance(*p.dragged_tolerance_mm);
    if (!p.hasAxis()) return;
    const double factor = p.factor->value();
    p.meridian->setData(magnifiedMeridian(result, screenLanguage(), factor));
    p.along->setData(deviationAlongAxis(result, screenLanguage()));
    p.map->setData(unrolledMap(result, p.greenWithin().has_value(), *p.outcome->form.map_mean_mm));
}

/// Both limits follow the dragged one.
void CompareViews::showTolerance(double tolerance_mm)
{
    parts_->histogram->setHandle("lower", -tolerance_mm, 0);
    parts_->histogram->setHandle("upper", tolerance_mm, 0);
}

void CompareViews::setLimit(std::optional<double> limit_mm, std::optional<double> lower_mm)
{
    parts_->chosen_limit_mm = limit_mm;
    parts_->chosen_lower_mm = limit_mm ? lower_mm : std::nullopt;
    recolour(parts_->greenWithin());
}

void CompareViews::setPlace(const std::optional<cad::ComparePlace>& place)
{
    Parts& p = *parts_;
    p.place = place;
    p.section->setEnabled(place && place->z_mm && p.hasAxis());
    if (!place) {
        p.scene->setMarker({});
        p.map->setMarker({});
        p.along->setMarker({});
        p.meridian->setMarker({});
        p.histogram->setMarker({});
        p.zones->markZ({});
        p.sizes->markZ({});
        return;
    }
    p.scene->setMarker(
        p.showsSkin() ? shownPlace_mm(*p.outcome, place->reference_mm, p.factor->value()) : place->reference_mm,
        allWords(*place));
    const bool onMap = place->z_mm && place->angle_deg;
    p.map->setMarker(onMap ? std::optional(QPointF(*place->z_mm, *place->angle_deg)) : std::nullopt);
    p.along->setMarker(place->z_mm);
    p.meridian->setMarker(place->z_mm);
    p.histogram->setMarker(place->deviation_mm ? place->deviation_mm : place->local_mean_mm);
    p.zones->markZ(place->z_mm);
    p.sizes->markZ(place->z_mm);
}

/// Pointer tag: the coloured value, then its place.
void CompareViews::tag(const cad::ComparePlace& place)
{
    const Parts& p = *parts_;
    const bool means = p.smooth->isChecked() && place.local_mean_mm;
    p.scene->setTag(valueWords(means ? place.local_mean_mm : place.deviation_mm), placeWords(place));
}

}  // namespace lathelier::compare_panel
