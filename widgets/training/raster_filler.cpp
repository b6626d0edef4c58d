#include "widgets/training/raster_filler.h"

#include <array>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"

namespace lathelier::training_panel {
namespace {

constexpr std::array<int, 4> passes{25, 50, 100, 200};  ///< columns, and rows
constexpr int poll_ms = 30;

std::string questionOf(const std::vector<stability::Mode>& modes, const stability::RasterParameters& p)
{
    const Json all = {p.cutting_coefficient_N_mm2, p.speed_rpm.from, p.speed_rpm.to, p.depth_mm.from, p.depth_mm.to,
                      p.direction_factor};
    return all.dump() + keyOf(modes);
}

}  // namespace

RasterFiller::RasterFiller(QObject* parent) : QObject(parent)
{
    poll_.setInterval(poll_ms);
    connect(&poll_, &QTimer::timeout, this, &RasterFiller::poll);
}

void RasterFiller::ask(const std::vector<stability::Mode>& modes, const stability::RasterParameters& parameters)
{
    std::string question = questionOf(modes, parameters);
    if (question == question_) return;
    question_ = std::move(question);
    modes_ = modes;
    asked_ = parameters;
    pass_ = 0;
    raster_.reset();
    next();
}

void RasterFiller::next()
{
    stability::RasterParameters p = asked_;
    p.columns = p.rows = passes[pass_];
    worker_.request([modes = modes_, p](const Progress& progress) -> std::shared_ptr<const void> {
        return std::make_shared<const stability::RasterResult>(stabilityRaster(modes, p, progress));
    });
    poll_.start();
}

void RasterFiller::poll()
{
    auto outcome = worker_.take();
    if (!outcome) return;
    poll_.stop();
    const auto* value = std::get_if<std::shared_ptr<const void>>(&*outcome);
    if (!value) return;  // without a map the chart keeps its plain regions
    raster_ = std::static_pointer_cast<const stability::RasterResult>(*value);
    emit filled();
    if (++pass_ < passes.size()) next();
}

}  // namespace lathelier::training_panel
