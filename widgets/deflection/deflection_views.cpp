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
      heroes_(new HeroViews),
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
    heroes_->add("error", both);
    heroes_->add("stock", stock_);
    heroes_->add("findings", findings_);
    heroes_->add("forces", forces_);
    heroes_->add("depth", depth_);
    heroes_->add("power", power_);
    heroes_->add("map", map_);
    heroes_->add("feed", feed_);
    heroes_->add("sensitivities", sensitivities_);
    heroes_->add("compliance", compliance_);
    heroes_->add("diameters", diameters_);
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
    layout->addWidget(heroes_, 1);
    connect(shape_, &plot::ChartView::handleMoved, this, [this](const QString& key, double z_mm, double, bool) {
        if (key == deflection::toolKey) setTool(z_mm);
    });
    for (plot::ChartView* chart : {error_, forces_, depth_, power_, feed_})
        connect(chart, &plot::ChartView::clicked, this, [this](double z_mm, double) { setTool(z_mm); });
    retranslate();
}

void DeflectionViews::setPicture(const std::shared_ptr<const DeflectionPicture>& picture)
{
    picture_ = picture;
    if (!is_tool_placed_) {
        const deflection::FinalContour& contour = picture->study->prediction.final;
        const auto worst = std::max_element(contour.diameter_error_um.begin(), contour.diameter_error_um.end());
        tool_z_mm_ = contour.z_mm.at(static_cast<std::size_t>(worst - contour.diameter_error_um.begin()));
    }
    show();
}

void DeflectionViews::setTool(double z_mm)
{
    tool_z_mm_ = z_mm;
    is_tool_placed_ = true;
    showTool();
}

void DeflectionViews::show()
{
    if (!picture_) return;
    const deflection::TurningStudy& study = *picture_->study;
    const Language& language = screenLanguage();
    deflection::ErrorPlotParts parts;
    parts.band = study.band ? &*study.band : nullptr;
    parts.tolerance_um = study.parameters.tolerance_um;
    if (study.identified) parts.measured = study.identified->diameters;
    error_->setData(deflection::errorPlot(study.prediction, parts, language));
    depth_->setData(deflection::depthPlot(study.prediction, language));
    const auto& speed_m_min = picture_->question.map.cutting_speed_m_min;
    heroes_->setAvailable("power", speed_m_min.has_value());
    if (speed_m_min) power_->setData(deflection::powerPlot(study.prediction, *speed_m_min, language));
    heroes_->setAvailable("feed", study.feed.has_value());
    if (study.feed) feed_->setData(deflection::feedPlot(*study.feed));
    heroes_->setAvailable("map", study.map.has_value());
    if (study.map) map_->setData(deflection::mapChart(*study.map, language));
    heroes_->setAvailable("stock", study.stock.has_value());
    heroes_->setAvailable("findings", study.stock && !study.stock->findings.empty());
    if (study.stock) {
        constexpr int enough_px = 2000;
        stock::StockPlotParts drawn;
        drawn.path = &picture_->drawn;
        drawn.window = picture_->drawn.whole(enough_px);
        stock_->setData(stock::stockPlot(*study.stock, drawn, language));
        findings_->setTable(deflection::findingsTable(*study.stock));
    }
    compliance_->setData(deflection::compliancePlot(study.compliance));
    heroes_->setAvailable("sensitivities", study.swings.has_value());
    if (study.swings) sensitivities_->setTable(deflection::sensitivityTable(*study.swings));
    heroes_->setAvailable("diameters", study.identified.has_value());
    if (study.identified) diameters_->setTable(deflection::diameterTable(*study.identified));
    showTool();
}

void DeflectionViews::showTool()
{
    if (!picture_) return;
    const std::vector<deflection::PassResult>& passes = picture_->study->prediction.passes;
    if (passes.empty()) return;
    // The last pass that cuts there.
    std::size_t pass = passes.size() - 1;
    for (std::size_t i = passes.size(); i-- > 0;)
        if (passes[i].z_mm.front() <= tool_z_mm_ && tool_z_mm_ <= passes[i].z_mm.back()) {
            pass = i;
            break;
        }
    const auto shape = deflection::deflectedShape(picture_->job->plan, picture_->job->setup, pass, tool_z_mm_);
    shape_->setData(deflection::shapePlot(shape));
    forces_->setData(deflection::forcesPlot(passes[pass]));
    for (plot::ChartView* chart : {error_, forces_, depth_, power_, feed_}) chart->setMarker(shape.tool_z_mm);
}

void DeflectionViews::retranslate()
{
    heroes_->setTitle("error", tr("Error and bent work"));
    heroes_->setTitle("stock", tr("Stock after each pass"));
    heroes_->setTitle("findings", tr("What the tool meets"));
    heroes_->setTitle("forces", tr("Forces"));
    heroes_->setTitle("depth", tr("Depth"));
    heroes_->setTitle("power", tr("Power"));
    heroes_->setTitle("map", tr("Depth and feed"));
    heroes_->setTitle("feed", tr("Feed along z"));
    heroes_->setTitle("sensitivities", tr("Sensitivities"));
    heroes_->setTitle("compliance", tr("Compliance"));
    heroes_->setTitle("diameters", tr("Measured"));
    sensitivities_->setAccessibleName(tr("Sensitivities"));
    findings_->setAccessibleName(tr("What the tool meets"));
    diameters_->setAccessibleName(tr("Measured diameters"));
    show();
}

}  // namespace lathelier::deflection_panel
