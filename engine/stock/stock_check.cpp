#include "engine/stock/stock_check.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/stock/move_findings.h"
#include "engine/stock/stock_codes.h"
#include "engine/stock/stock_work.h"
#include "engine/stock/tool_set.h"
#include "engine/stock/tool_travel.h"

namespace lathelier::stock {
namespace {

constexpr std::size_t mostNotes = 50;     ///< of one kind
constexpr double longestStrokes = 20000;  ///< largest number of steps of one straight move
constexpr std::size_t reportEvery = 64;   ///< moves between progress reports

/// A straight stretch of the tip path.
struct Leg {
    Corner from, to;
};

class Simulation {
public:
    Simulation(const ToolSet& tools, const StockParameters& parameters, const StockSteps& steps, MeridianStock stock,
               std::size_t outline_every, StockResult& result)
        : tools_(tools),
          parameters_(parameters),
          steps_(steps),
          stock_(std::move(stock)),
          outlineEvery_(outline_every),
          result_(result)
    {
        if (parameters.chuck)
            regions_.push_back({FindingKind::Chuck, regionOf(*parameters.chuck, stock_.length_mm()), true});
        if (parameters.tailstock)
            for (ConvexPolygon& region : regionsOf(*parameters.tailstock))
                regions_.push_back({FindingKind::Tailstock, std::move(region), false});
    }

    void run(std::span<const gcode::Move> moves, const Progress& progress)
    {
        TipFollower follower(parameters_.z_zero_mm);
        ToolTravel travel;
        for (std::size_t i = 0; i < moves.size(); ++i) {
            if (i % reportEvery == 0) progress.report(static_cast<double>(i) / static_cast<double>(moves.size()));
            follower.take(moves[i], arcChord_mm, travel);
            tailstockStands_ = i >= parameters_.tailstock_from_move;
            if (!travel.is_in_reach) finishPass();
            if (!travel.corners.empty()) take(travel, progress);
        }
        finishPass();
        finish();
    }

private:
    struct Region {
        FindingKind kind;
        ConvexPolygon shape;
        bool is_deepest_right;  // else to the left
    };

    void take(const ToolTravel& travel, const Progress& progress)
    {
        const MountedTool& tool = tools_.at(travel.tool);
        const Corner from = travel.corners.front(), to = travel.corners.back();
        if (!travel.has_start && startsUnknown_++ == 0) firstUnknownLine_ = travel.line;
        if (travel.is_rapid || travel.tool != passTool_) finishPass();
        passTool_ = travel.tool;
        const bool is_on_axis = std::abs(from.x_mm) < same_mm && std::abs(to.x_mm) < same_mm;
        if (is_on_axis && !tool.is_stated) {
            if (!travel.is_rapid && !isDrillingNoted_)
                result_.notes.push_back(
                    {notes::drillingNotModelled, {{"line", travel.line}, {"tool", std::int64_t{travel.tool}}}});
            isDrillingNoted_ = isDrillingNoted_ || !travel.is_rapid;
            return;
        }
        if (travel.is_rapid)
            takeRapid(tool, travel, {from, to});
        else
            takeFeed(tool, travel, progress);
        findings_.moveTo(result_.findings, travel.line, result_.findings_not_listed);
    }

    // Rapid moves.

    void takeRapid(const MountedTool& tool, const ToolTravel& travel, const Leg& leg)
    {
        const std::vector<Leg> straight{leg};
        const std::vector<Leg> bent = parameters_.dog_leg ? dogLeg(leg) : std::vector<Leg>{};
        const bool is_same = parameters_.dog_leg && bent.size() < 2;
        const MovePath first = !travel.has_start ? MovePath::Programmed : is_same ? MovePath::Both : MovePath::Straight;
        const bool hits_first = testRapid(tool, straight, first);
        const bool hits_second = bent.size() > 1 && testRapid(tool, bent, MovePath::DogLeg);
        if (hits_first) removeSweeps(tool, straight);
        if (hits_second) removeSweeps(tool, bent);
        if (hits_first || hits_second) return;
        const bool is_near = isNear(tool, straight) || (bent.size() > 1 && isNear(tool, bent));
        if (is_near && smallClearances_++ < mostNotes)
            result_.notes.push_back({notes::smallClearance, {{"line", travel.line}, {"z_mm", near_mm_}}});
    }

    /// Both axes move at their own rates until one arrives, then the other alone. Fewer than two: a straight line.
    std::vector<Leg> dogLeg(const Leg& leg) const
    {
        const Corner way = leg.to - leg.from;
        const double z_time = std::abs(way.z_mm) / parameters_.rapid_z_m_min;
        const double x_time = std::abs(way.x_mm) / parameters_.rapid_x_m_min;
        const double least = std::min(z_time, x_time), most = std::max(z_time, x_time);
        if (!(least > 0) || most - least < 1e-9 * most) return {};
        const Corner middle{z_time > least ? leg.from.z_mm + way.z_mm * (least / z_time) : leg.to.z_mm,
                            x_time > least ? leg.from.x_mm + way.x_mm * (least / x_time) : leg.to.x_mm};
        return {{leg.from, middle}, {middle, leg.to}};
    }

    bool testRapid(const MountedTool& tool, const std::vector<Leg>& legs, MovePath path)
    {
        bool hits_stock = false;
        for (const Leg& leg : legs)
            for (const ToolBody& body : tool.bodies) {
                const ConvexPolygon swept = sweep(body.shape, leg);
                if (const StockOverlap met = meetsStock(swept); met.isThere()) {
                    findings_.add(FindingKind::RapidThroughStock, path, met);
                    hits_stock = true;
                }
                testRegions(swept, path);
            }
        return hits_stock;
    }

    void removeSweeps(const MountedTool& tool, const std::vector<Leg>& legs)
    {
        for (const Leg& leg : legs)
            for (const ToolBody& body : tool.bodies)
                result_.removed_by_findings_mm3 += stock_.remove(sweep(body.shape, leg)).volume_mm3;
    }

    /// True if the move is near the stock beyond twice the clearance from its start, as a tool may leave the surface
    /// just cut.
    bool isNear(const MountedTool& tool, std::vector<Leg> legs)
    {
        double away_mm = 2 * smallClearance_mm;
        for (Leg& leg : legs) {
            const Corner way = leg.to - leg.from;
            const double length = length_mm(way);
            if (away_mm >= length) {
                away_mm -= length;
                continue;
            }
            leg.from = leg.from + away_mm / length * way;
            away_mm = 0;
            for (const ToolBody& body : tool.bodies)
                if (const StockOverlap met = stock_.overlap(sweep(body.grown, leg), parameters_.touch_mm);
                    met.isThere()) {
                    near_mm_ = met.z_mm;
                    return true;
                }
        }
        return false;
    }

    // Feed moves.

    void takeFeed(const MountedTool& tool, const ToolTravel& travel, const Progress& progress)
    {
        if (travel.is_thread && !isThreadNoted_) {
            result_.notes.push_back({notes::threadAsRoot, {{"line", travel.line}}});
            isThreadNoted_ = true;
        }
        double removed_mm3 = 0;
        bool holder_hits = false;
        const std::vector<Leg> legs = legsOf(travel);
        for (const Leg& leg : legs) {
            const Corner way = leg.to - leg.from;
            const bool has_holder = tool.bodies.size() > 1;
            const double strokes =
                has_holder ? std::clamp(std::ceil(length_mm(way) / steps_.feed_mm), 1.0, longestStrokes) : 1;
            for (double i = 0; i < strokes; ++i) {
                progress.check();
                const Leg stroke{leg.from + i / strokes * way,
                                 i + 1 < strokes ? leg.from + (i + 1) / strokes * way : leg.to};
                removed_mm3 += stock_.remove(sweep(tool.bodies.front().shape, stroke)).volume_mm3;
                holder_hits = testFeed(tool, stroke) || holder_hits;
            }
        }
        if (holder_hits)
            for (const Leg& leg : legs)
                for (const ToolBody& body : tool.bodies)
                    result_.removed_by_findings_mm3 += stock_.remove(sweep(body.shape, leg)).volume_mm3;
        if (removed_mm3 > 0) {
            if (pass_.line == 0) pass_.line = travel.line;
            pass_.tool = travel.tool;
            pass_.removed_mm3 += removed_mm3;
        } else {
            noteAirCut(tool, travel);
        }
    }

    static std::vector<Leg> legsOf(const ToolTravel& travel)
    {
        std::vector<Leg> legs;
        const std::vector<Corner>& corners = travel.corners;
        if (corners.size() == 1) legs.push_back({corners.front(), corners.front()});
        for (std::size_t i = 1; i < corners.size(); ++i) legs.push_back({corners[i - 1], corners[i]});
        return legs;
    }

    bool testFeed(const MountedTool& tool, const Leg& stroke)
    {
        bool holder_hits = false;
        for (const ToolBody& body : tool.bodies) {
            if (!body.is_holder && regions_.empty()) continue;
            const ConvexPolygon swept = sweep(body.shape, stroke);
            testRegions(swept, MovePath::Programmed);
            if (!body.is_holder) continue;
            if (const StockOverlap met = meetsStock(swept); met.isThere()) {
                findings_.add(FindingKind::HolderInStock, MovePath::Programmed, met);
                holder_hits = true;
            }
        }
        return holder_hits;
    }

    void noteAirCut(const MountedTool& tool, const ToolTravel& travel)
    {
        const Corner from = travel.corners.front(), to = travel.corners.back();
        if (to.x_mm > from.x_mm + same_mm) return;  // a retract
        const double a_mm = std::clamp(from.z_mm, 0.0, stock_.length_mm());
        const double b_mm = std::clamp(to.z_mm, 0.0, stock_.length_mm());
        if (std::abs(b_mm - a_mm) < airCut_mm) return;
        for (const Leg& leg : legsOf(travel))
            if (stock_.overlap(sweep(tool.bodies.front().grown, leg)).isThere()) return;
        if (airCuts_++ < mostNotes)
            result_.notes.push_back(
                {notes::aboveStockFeed, {{"line", travel.line}, {"z_mm", a_mm}, {"length_mm", std::abs(b_mm - a_mm)}}});
    }

    // Both.

    static ConvexPolygon sweep(const ConvexPolygon& shape, const Leg& leg)
    {
        return sweptBy(movedBy(shape, leg.from), leg.to - leg.from);
    }

    StockOverlap meetsStock(const ConvexPolygon& swept) const
    {
        const StockOverlap met = stock_.overlap(swept, parameters_.touch_mm);
        if (!met.isThere() || !stock_.overlap(shrunkBy(swept, parameters_.touch_mm)).isThere()) return {};
        return met;
    }

    void testRegions(const ConvexPolygon& swept, MovePath path)
    {
        for (const Region& region : regions_) {
            if (region.kind == FindingKind::Tailstock && !tailstockStands_) continue;
            const Box tool = boxOf(swept), other = boxOf(region.shape);
            if (tool.high.z_mm <= other.low.z_mm || tool.low.z_mm >= other.high.z_mm ||
                tool.low.x_mm >= other.high.x_mm)
                continue;
            const Box met = boxOf(overlapOf(swept, region.shape));
            const Corner extent = met.high - met.low;
            const double depth_mm = std::min(extent.z_mm, extent.x_mm);
            if (!(depth_mm > parameters_.touch_mm)) continue;
            const double deepest_mm = region.is_deepest_right ? met.high.z_mm : met.low.z_mm;
            findings_.add(region.kind, path, {depth_mm, deepest_mm, met.low.x_mm, extent.z_mm});
        }
    }

    void finishPass()
    {
        if (pass_.line != 0) {
            pass_.is_kept = result_.passes.size() % outlineEvery_ == outlineEvery_ - 1;
            if (pass_.is_kept) pass_.after = outlineOf(stock_, outlineTolerance_mm);
            result_.removed_mm3 += pass_.removed_mm3;
            result_.passes.push_back(std::move(pass_));
        }
        pass_ = {};
    }

    void finish()
    {
        if (!result_.passes.empty() && !result_.passes.back().is_kept) {
            result_.passes.back().after = outlineOf(stock_, outlineTolerance_mm);
            result_.passes.back().is_kept = true;
        }
        const auto noteMore = [this](std::size_t found, Text what) {
            if (found > mostNotes)
                result_.notes.push_back(
                    {notes::morePlaces, {{"what", what}, {"count", static_cast<std::int64_t>(found - mostNotes)}}});
        };
        noteMore(smallClearances_, LT_TEXT("Engine", "a small clearance"));
        noteMore(airCuts_, LT_TEXT("Engine", "a feed move above the stock"));
        if (startsUnknown_ > 0)
            result_.notes.push_back(
                {notes::startUnknown,
                 {{"line", firstUnknownLine_}, {"count", static_cast<std::int64_t>(startsUnknown_)}}});
        if (outlineEvery_ > 1 && parameters_.most_outlines > 1)
            result_.notes.push_back({notes::outlinesThinned,
                                     {{"every", static_cast<std::int64_t>(outlineEvery_)},
                                      {"passes", static_cast<std::int64_t>(result_.passes.size())}}});
        result_.left = std::move(stock_);
    }

    const ToolSet& tools_;
    const StockParameters& parameters_;
    StockSteps steps_;
    MeridianStock stock_;
    std::size_t outlineEvery_;
    StockResult& result_;
    std::vector<Region> regions_;
    MoveFindings findings_;
    StockPass pass_;
    int passTool_ = 0;
    double near_mm_ = 0;
    std::size_t smallClearances_ = 0, airCuts_ = 0, startsUnknown_ = 0;
    std::int64_t firstUnknownLine_ = 0;
    bool isThreadNoted_ = false, isDrillingNoted_ = false;
    bool tailstockStands_ = true;
};

void simulate(const ToolSet& tools, const StockSteps& steps, MeridianStock columns, std::span<const gcode::Move> moves,
              const StockParameters& parameters, const Progress& progress, StockResult& result)
{
    result.step_mm = columns.step_mm();
    result.length_mm = columns.length_mm();
    result.volume_before_mm3 = columns.volume_mm3();
    result.before = outlineOf(columns, outlineTolerance_mm);
    const std::size_t most = std::max<std::size_t>(parameters.most_outlines, 1);
    const std::size_t every = most > 1 ? countRuns(moves) / most + 1 : moves.size() + 1;
    Simulation(tools, parameters, steps, std::move(columns), every, result).run(moves, progress);
}

}  // namespace

StockResult simulateStock(MeridianStock columns, std::span<const gcode::Move> moves, const StockParameters& parameters,
                          const Progress& progress)
{
    StockResult result;
    result.parameters = parameters;
    const ToolSet tools(moves, parameters.tools, smallClearance_mm, result.notes);
    StockSteps steps = stepsFor(columns.length_mm(), moves, tools.width_mm(), parameters);
    steps.column_mm = columns.step_mm();
    simulate(tools, steps, std::move(columns), moves, parameters, progress, result);
    return result;
}

StockResult simulateStock(const Shaft& stock, std::span<const gcode::Move> moves, const StockParameters& parameters,
                          const Progress& progress)
{
    StockResult result;
    result.parameters = parameters;
    const ToolSet tools(moves, parameters.tools, smallClearance_mm, result.notes);
    const StockSteps steps = stepsFor(stock.length_mm(), moves, tools.width_mm(), parameters);
    MeridianStock columns(stock, steps.column_mm);
    if (steps.column_mm > parameters.step_mm * (1 + 1e-9))
        result.notes.push_back(
            {notes::stockStepWidened,
             {{"step_mm", columns.step_mm()}, {"asked_mm", parameters.step_mm}, {"feed_step_mm", steps.feed_mm}}});
    simulate(tools, steps, std::move(columns), moves, parameters, progress, result);
    return result;
}

}  // namespace lathelier::stock
