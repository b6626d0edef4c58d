#include "engine/cam/work_stock.h"

#include <algorithm>
#include <cmath>

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double stockChord_mm = 0.02;
constexpr double holderTestStep_mm = 1;
constexpr double liftStep_mm = 0.25;

}  // namespace

WorkStock::WorkStock(const Shaft& stock, const stock::StockParameters& parameters)
    : WorkStock(stock::MeridianStock(stock, parameters.step_mm), parameters)
{
}

WorkStock::WorkStock(stock::MeridianStock stock, const stock::StockParameters& parameters)
    : columns_(std::move(stock)), parameters_(parameters)
{
    for (const Tool& tool : parameters.tools) {
        stock::ToolOutline outline = stock::outlineOf(tool);
        tools_.push_back({tool.number, std::move(outline.insert), std::move(outline.holders)});
    }
    if (parameters.chuck)
        regions_.emplace_back(stock::FindingKind::Chuck, regionOf(*parameters.chuck, columns_.length_mm()));
    if (parameters.tailstock)
        for (stock::ConvexPolygon& region : regionsOf(*parameters.tailstock))
            regions_.emplace_back(stock::FindingKind::Tailstock, std::move(region));
}

const WorkStock::Mounted* WorkStock::mounted(int number) const
{
    for (const Mounted& tool : tools_)
        if (tool.number == number) return &tool;
    return nullptr;
}

bool WorkStock::meets(const stock::ConvexPolygon& swept) const
{
    return columns_.overlap(swept, parameters_.touch_mm).isThere() &&
           columns_.overlap(shrunkBy(swept, parameters_.touch_mm)).isThere();
}

std::optional<Refusal> WorkStock::test(const stock::ConvexPolygon& swept, stock::FindingKind kind) const
{
    if (meets(swept)) {
        const stock::StockOverlap overlap = columns_.overlap(swept, parameters_.touch_mm);
        return Refusal{kind, overlap.z_mm - parameters_.z_zero_mm, overlap.depth_mm};
    }
    for (const auto& [region_kind, shape] : regions_) {
        if (region_kind == stock::FindingKind::Tailstock && !tailstockStands_) continue;
        const stock::Box met = boxOf(overlapOf(swept, shape));
        const stock::Corner extent = met.high - met.low;
        if (std::min(extent.z_mm, extent.x_mm) > parameters_.touch_mm)
            return Refusal{region_kind, met.low.z_mm - parameters_.z_zero_mm, std::min(extent.z_mm, extent.x_mm)};
    }
    return {};
}

std::optional<Refusal> WorkStock::run(const Operation& operation)
{
    const Mounted* tool = mounted(operation.tool);
    if (!tool) return {};
    std::optional<Refusal> first;
    const auto note = [&first](const std::optional<Refusal>& found) {
        if (found && !first) first = found;
    };
    const auto place = [this](const Vector2d& tip) { return stock::Corner{tip.x() + parameters_.z_zero_mm, tip.y()}; };
    Vector2d at = operation.moves.empty() ? Vector2d(0, 0) : operation.moves.front().to;
    for (const CutMove& move : operation.moves) {
        for (const Vector2d& to : chordsOf(at, move, stockChord_mm)) {
            const stock::Corner from = place(at), way = place(to) - place(at);
            const auto sweep = [&](const stock::ConvexPolygon& body, double begin, double end) {
                return sweptBy(movedBy(body, from + begin * way), (end - begin) * way);
            };
            if (move.kind == CutKind::Rapid) {
                note(test(sweep(tool->insert, 0, 1), stock::FindingKind::RapidThroughStock));
                for (const auto& holder : tool->holders)
                    note(test(sweep(holder, 0, 1), stock::FindingKind::RapidThroughStock));
            } else {
                const double steps =
                    tool->holders.empty() ? 1 : std::max(1.0, std::ceil(length_mm(way) / holderTestStep_mm));
                for (double i = 0; i < steps; ++i) {
                    const stock::ConvexPolygon cut = sweep(tool->insert, i / steps, (i + 1) / steps);
                    removed_mm3_ += columns_.remove(cut).volume_mm3;
                    note(test(cut, stock::FindingKind::Chuck));
                    for (const auto& holder : tool->holders)
                        note(test(sweep(holder, i / steps, (i + 1) / steps), stock::FindingKind::HolderInStock));
                }
            }
            at = to;
        }
    }
    return first;
}

double WorkStock::reachableFromAbove_mm(int number, double z_mm, double x_mm, double safe_x_mm) const
{
    const Mounted* tool = mounted(number);
    if (!tool) return x_mm;
    for (double x = x_mm; x < safe_x_mm; x += liftStep_mm) {
        const stock::Corner from{z_mm + parameters_.z_zero_mm, safe_x_mm}, way{0, x - safe_x_mm};
        const auto is_clear = [&](const stock::ConvexPolygon& body) {
            const stock::ConvexPolygon swept = sweptBy(movedBy(body, from), way);
            return !columns_.overlap(stock::grownBy(swept, approachClearance_mm)).isThere();
        };
        if (is_clear(tool->insert) && std::all_of(tool->holders.begin(), tool->holders.end(), is_clear)) return x;
    }
    return safe_x_mm;
}

double WorkStock::topBetween_mm(double from_mm, double to_mm) const
{
    double top = 0;
    const double step = columns_.step_mm(), zero = parameters_.z_zero_mm;
    const auto count = static_cast<double>(columns_.columns());
    const double first = std::clamp(std::floor((from_mm + zero) / step), 0.0, count);
    const double last = std::clamp(std::ceil((to_mm + zero) / step), 0.0, count);
    for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
        if (const auto radius = columns_.outerRadius_mm(columns_.middle_mm(i))) top = std::max(top, *radius);
    return top;
}

Shaft WorkStock::bodyUpTo(double to_z_mm, double piece_mm) const
{
    Shaft body;
    const double step = columns_.step_mm(), end = to_z_mm + parameters_.z_zero_mm;
    const auto count = std::min(columns_.columns(), static_cast<std::size_t>(std::max(0.0, std::round(end / step))));
    const auto group = static_cast<std::size_t>(std::max(1.0, std::round(piece_mm / step)));
    double begin_d = -1, length = 0;
    const auto flush = [&] {
        if (length > 0 && begin_d > 0) {
            ShaftSegment segment;
            segment.length_mm = length;
            segment.start_diameter_mm = segment.end_diameter_mm = begin_d;
            body.segments.push_back(segment);
        }
        length = 0;
    };
    for (std::size_t i = 0; i < count; i += group) {
        const std::size_t last = std::min(count, i + group);
        double square = 0;
        for (std::size_t k = i; k < last; ++k) {
            const double radius = columns_.outerRadius_mm(columns_.middle_mm(k)).value_or(0);
            square += radius * radius;
        }
        const double diameter = 2 * std::sqrt(square / static_cast<double>(last - i));
        if (diameter <= 0) continue;
        if (std::abs(diameter - begin_d) > 0.02) {
            flush();
            begin_d = diameter;
        }
        length += static_cast<double>(last - i) * step;
    }
    flush();
    return body;
}

}  // namespace lathelier::cam
