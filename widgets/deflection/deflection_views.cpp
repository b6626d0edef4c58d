#include "widgets/deflection/deflection_views.h"

#include <QVBoxLayout>
#include <algorithm>

#include "engine/deflection/deflected_shape.h"
#include "engine/deflection/deflection_plots.h"
#include "engine/deflection/map_chart.h"
#include "engine/stock/stock_plots.h"
#include "widgets/core/language.h"

namespace lathelier::deflection_panel {

DeflectionViews::DeflectionViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
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
    stacked->addWidget(error_, 3);
    stacked->addWidget(shape_, 2);
    primaryViews_->add("error", both);
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
}

void DeflectionViews::retranslate()
{
    primaryViews_->setTitle("error", tr("Error and bent work"));
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
