#include "widgets/deflection/deflection_views.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/deflection/bent_skin.h"
#include "engine/deflection/deflection_plots.h"
#include "engine/deflection/map_chart.h"
#include "engine/stock/stock_plots.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/view_frame.h"

namespace lathelier::deflection_panel {
namespace {

double toolRadius_mm(const Skin& skin, double z_mm)
{
    const SkinStation* nearest = &skin.stations.front();
    for (const SkinStation& station : skin.stations)
        if (!station.isFace() && std::abs(station.z_mm - z_mm) < std::abs(nearest->z_mm - z_mm)) nearest = &station;
    return nearest->radius_mm;
}

}  // namespace

DeflectionViews::DeflectionViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      bent_(new scene::SceneView),
      remark_(new QLabel),
      error_(new plot::ChartView),
      shape_(new plot::ChartView),
      forces_(new plot::ChartView),
      depth_(new plot::ChartView),
      power_(new plot::ChartView),
      feed_(new plot::ChartView),
      map_(new plot::ChartView),
      compliance_(new plot::ChartView),
      stock_(new plot::ChartView),
      sensitivities_(new CopyTable),
      diameters_(new CopyTable),
      findings_(new CopyTable)
{
    auto* both = new QWidget;
    auto* stacked = new QVBoxLayout(both);
    stacked->setContentsMargins(0, 0, 0, 0);
    stacked->setSpacing(0);
    stacked->addWidget(remark_);
    stacked->addWidget(bent_, 3);
    stacked->addWidget(error_, 2);
    bent_->setVisible(bent_->canDraw());
    bent_->setObjectName("deflectionBent");
    remark_->setObjectName("deflectionRemark");
    remark_->setProperty(ViewFrame::onlyLarge, true);
    primaryViews_->add("error", both);
    primaryViews_->add("shape", shape_);
    primaryViews_->add("stock", stock_);
    primaryViews_->add("findings", findings_);
    primaryViews_->add("forces", forces_);
    primaryViews_->add("depth", depth_);
    primaryViews_->add("power", power_);
    primaryViews_->add("map", map_);
    primaryViews_->add("feed", feed_);
    primaryViews_->add("sensitivities", sensitivities_);
    primaryViews_->add("compliance", compliance_);
    primaryViews_->add("diameters", diameters_);
    const std::pair<const char*, plot::PlotWidget*> plots[] = {
        {"deflectionError", error_},           {"deflectionShape", shape_}, {"deflectionForces", forces_},
        {"deflectionDepth", depth_},           {"deflectionPower", power_}, {"deflectionMap", map_},
        {"deflectionCompliance", compliance_}, {"deflectionStock", stock_}, {"deflectionFeed", feed_}};
    for (const auto& [name, view] : plots) {
        view->setObjectName(name);
        connect(view, &plot::PlotWidget::notWritten, this, &DeflectionViews::notWritten);
    }
    sensitivities_->setObjectName("deflectionSensitivities");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    connect(shape_, &plot::ChartView::handleMoved, this, [this](const QString& key, double z_mm, double, bool) {
        if (key == deflection::toolKey) setTool(z_mm);
    });
    connect(bent_, &scene::SceneView::limitEdited, this, [this](double upper_um, double lower_um) {
        report::DeviationColours colours{upper_um};
        colours.steps = report::contourSteps;
        if (lower_um > 0) colours.lower = lower_um;
        chosenColours_ = colours;
        bent_->setColours(colours);
    });
    connect(bent_, &scene::SceneView::notWritten, this, &DeflectionViews::notWritten);
    for (plot::ChartView* chart : {error_, forces_, depth_, power_, feed_})
        connect(chart, &plot::ChartView::clicked, this, [this](double z_mm, double) { setTool(z_mm); });
    retranslate();
}

void DeflectionViews::setOutcome(const std::shared_ptr<const DeflectionOutcome>& outcome)
{
    outcome_ = outcome;
    if (!isToolPlaced_) {
        const deflection::FinalContour& contour = outcome->study->prediction.final;
        const auto worst = std::max_element(contour.diameter_error_um.begin(), contour.diameter_error_um.end());
        toolZ_mm_ = contour.z_mm.at(static_cast<std::size_t>(worst - contour.diameter_error_um.begin()));
    }
    show();
}

void DeflectionViews::setTool(double z_mm)
{
    toolZ_mm_ = z_mm;
    isToolPlaced_ = true;
    showTool();
}

void DeflectionViews::show()
{
    if (!outcome_) return;
    const deflection::TurningStudy& study = *outcome_->study;
    const Language& language = screenLanguage();
    deflection::ErrorPlotParts parts;
    parts.band = study.band ? &*study.band : nullptr;
    parts.tolerance_um = study.parameters.tolerance_um;
    if (study.identified) parts.measured = study.identified->diameters;
    error_->setData(deflection::errorPlot(study.prediction, parts, language));
    depth_->setData(deflection::depthPlot(study.prediction, language));
    const auto& speed_m_min = outcome_->question.map.cutting_speed_m_min;
    primaryViews_->setAvailable("power", speed_m_min.has_value());
    if (speed_m_min) power_->setData(deflection::powerPlot(study.prediction, *speed_m_min, language));
    primaryViews_->setAvailable("feed", study.feed.has_value());
    if (study.feed) feed_->setData(deflection::feedPlot(*study.feed));
    primaryViews_->setAvailable("map", study.map.has_value());
    if (study.map) map_->setData(deflection::mapChart(*study.map, language));
    primaryViews_->setAvailable("stock", study.stock.has_value());
    primaryViews_->setAvailable("findings", study.stock && !study.stock->findings.empty());
    if (study.stock) {
        constexpr int enough_px = 2000;
        stock::StockPlotParts drawn;
        drawn.path = &outcome_->drawn;
        drawn.window = outcome_->drawn.whole(enough_px);
        stock_->setData(stock::stockPlot(*study.stock, drawn, language));
        findings_->setTable(deflection::findingsTable(*study.stock));
    }
    compliance_->setData(deflection::compliancePlot(study.compliance));
    primaryViews_->setAvailable("sensitivities", study.swings.has_value());
    if (study.swings) sensitivities_->setTable(deflection::sensitivityTable(*study.swings));
    primaryViews_->setAvailable("diameters", study.identified.has_value());
    if (study.identified) diameters_->setTable(deflection::diameterTable(*study.identified));
    showTool();
}

void DeflectionViews::showTool()
{
    if (!outcome_) return;
    const std::vector<deflection::PassResult>& passes = outcome_->study->prediction.passes;
    if (passes.empty()) return;
    // The last pass that cuts there.
    std::size_t pass = passes.size() - 1;
    for (std::size_t i = passes.size(); i-- > 0;)
        if (passes[i].z_mm.front() <= toolZ_mm_ && toolZ_mm_ <= passes[i].z_mm.back()) {
            pass = i;
            break;
        }
    const auto shape = deflection::deflectedShape(outcome_->job->plan, outcome_->job->setup, pass, toolZ_mm_);
    shape_->setData(deflection::shapePlot(shape));
    forces_->setData(deflection::forcesPlot(passes[pass]));
    for (plot::ChartView* chart : {error_, forces_, depth_, power_, feed_}) chart->setMarker(shape.tool_z_mm);
    showBent(shape);
}

void DeflectionViews::showBent(const deflection::DeflectedShape& shape)
{
    if (!bent_->canDraw()) return;
    const deflection::TurningStudy& study = *outcome_->study;
    const Skin skin = deflection::bentSkin(outcome_->job->plan, shape, study.prediction.final);
    const double factor = deflection::bendMagnification(skin);
    scene::SceneObject work;
    work.name = tr("Work");
    work.scan = std::make_shared<const Scan>(meshOf(skin, factor, Eigen::Isometry3d::Identity()));
    work.values = std::make_shared<const std::vector<float>>(skin.values);
    double largest_um = 0;
    for (const float value : skin.values)
        if (!std::isnan(value)) largest_um = std::max(largest_um, std::abs(static_cast<double>(value)));
    report::DeviationColours colours{report::niceLimit(std::max(largest_um, 1e-3))};
    colours.steps = report::contourSteps;
    bent_->setScale({LT_TEXT("Engine", "Diameter error"), micrometre});
    bent_->setColours(chosenColours_.value_or(colours));
    bent_->setLongAxis(scene::SceneAxis{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()});
    bent_->setObjects({work});
    remark_->setText(tr("Bend drawn × %1 while the tool cuts at z %2")
                         .arg(screenNumber(factor, 0), screenQuantity(shape.tool_z_mm, millimetre, 1)));
    const Eigen::Vector3d tool(toolRadius_mm(skin, shape.tool_z_mm), 0, shape.tool_z_mm);
    bent_->setFlags(
        {{displacedPlace(skin, tool, factor), tr("tool"), plot::toQt(report::colourOf(report::ColourRole::Limit))}});
}

void DeflectionViews::retranslate()
{
    primaryViews_->setTitle("error", tr("Bent work and its error"));
    primaryViews_->setTitle("shape", tr("Bent axis"));
    primaryViews_->setTitle("stock", tr("Stock after each pass"));
    primaryViews_->setTitle("findings", tr("What the tool meets"));
    primaryViews_->setTitle("forces", tr("Forces"));
    primaryViews_->setTitle("depth", tr("Depth"));
    primaryViews_->setTitle("power", tr("Power"));
    primaryViews_->setTitle("map", tr("Depth and feed"));
    primaryViews_->setTitle("feed", tr("Feed along z"));
    primaryViews_->setTitle("sensitivities", tr("Sensitivities"));
    primaryViews_->setTitle("compliance", tr("Compliance"));
    primaryViews_->setTitle("diameters", tr("Measured"));
    sensitivities_->setAccessibleName(tr("Sensitivities"));
    findings_->setAccessibleName(tr("What the tool meets"));
    diameters_->setAccessibleName(tr("Measured diameters"));
    show();
}

}  // namespace lathelier::deflection_panel
