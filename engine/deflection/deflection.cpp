#include "engine/deflection/deflection.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"

namespace lathelier::deflection {
namespace {

constexpr double clearSlope_rad =
    5 / deg_per_rad;  ///< on flatter slopes the forces differ from those of a cylinder by a few %
constexpr double largeDeflection_mm = 0.3;

void noteMoves(const WorkPlan& plan, const CutPlan& cut, const TurningWork& work, Notes& notes)
{
    if (cut.kind == ToolRun::Kind::Plunge) {
        const PathPoint& end = cut.run.points.back();
        const std::size_t piece = std::min(cut.first, plan.pieces() - 1);
        const bool meets = std::max(work.outerStart_mm()[piece], work.outerEnd_mm()[piece]) - end.x_mm > 1e-9;
        // At an end of the workpiece the tool is outside the stock.
        if (end.z_mm > 1e-6 && end.z_mm < plan.length_mm() && meets)
            notes.push_back({notes::plungeNotModelled, {{"line", end.line}, {"z_mm", end.z_mm}}});
        return;
    }
    if (work.meets(cut)) notes.push_back({notes::towardFreeEnd, {{"line", cut.pieces.front().line}}});
}

void noteLargest(const std::vector<PassResult>& passes, Notes& notes)
{
    double largest_um = 0, z_mm = 0;
    for (const PassResult& pass : passes)
        for (std::size_t i = 0; i < pass.z_mm.size(); ++i)
            if (const double size_um = std::hypot(pass.dx_um[i], pass.dy_um[i]); size_um > largest_um) {
                largest_um = size_um;
                z_mm = pass.z_mm[i];
            }
    if (largest_um > um_per_mm * largeDeflection_mm)
        notes.push_back({notes::largeDeflection, {{"deflection_mm", largest_um / um_per_mm}, {"z_mm", z_mm}}});
}

}  // namespace

PassResult passResultOf(const CutPlan& cut, std::span<const Station> stations)
{
    PassResult pass;
    if (!stations.empty()) pass.line = cut.pieces[stations.front().piece].line;
    for (std::vector<double>* list :
         {&pass.z_mm, &pass.x_mm, &pass.radius_mm, &pass.diameter_error_um, &pass.F_t_N, &pass.F_f_N, &pass.F_ap_N,
          &pass.depth_mm, &pass.dx_um, &pass.dy_um, &pass.stiffness_N_mm})
        list->reserve(stations.size());
    for (const Station& s : stations) {
        pass.z_mm.push_back(s.z_mm);
        pass.x_mm.push_back(s.x_mm);
        pass.radius_mm.push_back(s.radius_mm);
        pass.diameter_error_um.push_back(2 * um_per_mm * (s.radius_mm - s.x_mm));
        pass.F_t_N.push_back(s.forces.F_t_N);
        pass.F_f_N.push_back(s.forces.F_f_N);
        pass.F_ap_N.push_back(s.forces.F_ap_N);
        pass.depth_mm.push_back(s.depth_mm);
        pass.dx_um.push_back(um_per_mm * s.dx_mm);
        pass.dy_um.push_back(um_per_mm * s.dy_mm);
        pass.stiffness_N_mm.push_back(s.stiffness_N_mm);
    }
    return pass;
}

void noteStations(const CutPlan& cut, std::span<const Station> stations, const TurningSetup& setup, Notes& notes)
{
    const Station* rubbing = nullptr;
    const CutPiece* steepest = nullptr;
    for (const Station& s : stations) {
        if (s.rubs && !rubbing) rubbing = &s;
        const CutPiece& piece = cut.pieces[s.piece];
        if (!steepest || std::abs(piece.slope_rad) > std::abs(steepest->slope_rad)) steepest = &piece;
    }
    if (rubbing) {
        const CutPiece& piece = cut.pieces[rubbing->piece];
        const double scallop_mm = cutting::CuttingEdge(setup.tool, piece.feed_mm_rev, setup.contact).scallop_mm();
        notes.push_back({notes::belowScallop,
                         {{"line", piece.line}, {"z_mm", rubbing->z_mm}, {"scallop_um", um_per_mm * scallop_mm}}});
    }
    if (!steepest) return;
    const double slope_deg = steepest->slope_rad * deg_per_rad;
    if (setup.slope == SlopeModel::Radial && std::abs(steepest->slope_rad) > clearSlope_rad)
        notes.push_back({notes::slopeInRadialModel, {{"line", steepest->line}, {"slope_deg", slope_deg}}});
    if (setup.slope == SlopeModel::Normal && std::abs(steepest->slope_rad) > steepestSlope_rad)
        notes.push_back({notes::slopeTooSteep,
                         {{"line", steepest->line},
                          {"slope_deg", slope_deg},
                          {"used_deg", std::copysign(steepestSlope_rad * deg_per_rad, slope_deg)}}});
}

TargetContour::TargetContour(const WorkPlan& plan)
    : start_mm_(plan.pieces(), notANumber), end_mm_(plan.pieces(), notANumber)
{
}

double judgedTarget_mm(const CutPiece& asked, const Station& station, const TurningSetup& setup)
{
    const double target_mm = station.at_start ? asked.start_mm : asked.end_mm;
    constexpr double largestScallop_mm = 0.5;
    if (!asked.arc || station.stock_mm - target_mm > largestScallop_mm) return target_mm;
    const double scallop_mm = cutting::CuttingEdge(setup.tool, asked.feed_mm_rev, setup.contact).scallop_mm();
    const double least_mm = std::min(target_mm, station.stock_mm - scallop_mm);
    return std::clamp(station.radius_mm, least_mm, target_mm);
}

void TargetContour::take(const CutPlan& contour, std::span<const Station> stations, const TurningSetup* judged_by)
{
    for (const Station& s : stations) {
        const auto is_cut = [&](std::size_t piece, bool at_start) {
            const CutPiece& c = contour.pieces[piece];
            double& target_mm = (at_start ? start_mm_ : end_mm_)[contour.first + piece];
            target_mm = at_start ? c.start_mm : c.end_mm;
            if (judged_by && piece == s.piece) target_mm = judgedTarget_mm(c, s, *judged_by);
        };
        is_cut(s.piece, s.at_start);
        // One station represents both sides of a node without a jump.
        if (!s.at_start && s.piece + 1 < contour.pieces.size() &&
            contour.pieces[s.piece + 1].start_mm == contour.pieces[s.piece].end_mm) {
            is_cut(s.piece + 1, true);
            if (contour.pieces[s.piece].arc) start_mm_[contour.first + s.piece + 1] = end_mm_[contour.first + s.piece];
        }
    }
}

FinalContour TargetContour::against(const WorkPlan& plan, const TurningWork& work) const
{
    FinalContour found;
    for (std::vector<double>* list : {&found.z_mm, &found.target_radius_mm, &found.radius_mm, &found.diameter_error_um})
        list->reserve(plan.z_mm.size());
    bool is_gap = false;
    const auto add = [&](double z_mm, double target_mm, double radius_mm, bool is_unpredicted) {
        if (std::isnan(target_mm) || is_unpredicted) {
            is_gap = true;
            return;
        }
        if (!found.z_mm.empty() && found.z_mm.back() == z_mm && found.target_radius_mm.back() == target_mm &&
            found.radius_mm.back() == radius_mm)
            return;
        if (is_gap && !found.z_mm.empty()) found.gaps.push_back(found.z_mm.size());
        is_gap = false;
        found.z_mm.push_back(z_mm);
        found.target_radius_mm.push_back(target_mm);
        found.radius_mm.push_back(radius_mm);
        found.diameter_error_um.push_back(2 * um_per_mm * (radius_mm - target_mm));
    };
    for (std::size_t i = 0; i < plan.pieces(); ++i) {
        add(plan.z_mm[i], start_mm_[i], work.outerStart_mm()[i], work.isUnpredicted(i, true));
        add(plan.z_mm[i + 1], end_mm_[i], work.outerEnd_mm()[i], work.isUnpredicted(i, false));
    }
    return found;
}

ErrorSummary summaryOf(const FinalContour& contour)
{
    ErrorSummary summary;
    const std::vector<double>& e = contour.diameter_error_um;
    if (e.empty()) return summary;
    const auto [least, largest] = std::minmax_element(e.begin(), e.end());
    summary.max_um = std::max(std::abs(*least), std::abs(*largest));
    summary.range_um = *largest - *least;
    summary.wear_offset_um = -(*largest + *least) / 2;
    double length_mm = 0, sum = 0, plain = std::abs(e.front());
    auto gap = contour.gaps.begin();
    for (std::size_t i = 1; i < e.size(); ++i) {
        plain += std::abs(e[i]);
        if (gap != contour.gaps.end() && *gap == i) {
            ++gap;
            continue;
        }
        const double width_mm = contour.z_mm[i] - contour.z_mm[i - 1];
        length_mm += width_mm;
        sum += width_mm * (std::abs(e[i]) + std::abs(e[i - 1])) / 2;
    }
    summary.mean_abs_um = length_mm > 0 ? sum / length_mm : plain / static_cast<double>(e.size());
    return summary;
}

DeflectionResult predictDeflection(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                                   const Progress& progress)
{
    return predictDeflection(workPlan(stock, runs, setup), setup, progress);
}

DeflectionResult predictDeflection(const WorkPlan& plan, const TurningSetup& setup, const Progress& progress)
{
    DeflectionResult result;
    result.setup = setup;
    result.length_mm = plan.length_mm();
    TurningWork work(plan, setup);
    TargetContour targets(plan);
    std::vector<Station> stations;
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
        progress.report(static_cast<double>(i) / static_cast<double>(plan.cuts.size()));
        const CutPlan& cut = plan.cuts[i];
        if (cut.kind != ToolRun::Kind::TowardChuck) noteMoves(plan, cut, work, result.notes);
        work.take(cut, CutTask::Predict, stations);
        if (stations.empty()) continue;
        targets.take(cut, stations);
        noteStations(cut, stations, setup, result.notes);
        result.passes.push_back(passResultOf(cut, stations));
    }
    if (result.passes.empty()) throw Error(errors::noCut, {});
    result.final = targets.against(plan, work);
    if (result.final.z_mm.empty()) throw Error(errors::noCut, {});
    result.summary = summaryOf(result.final);
    noteLargest(result.passes, result.notes);
    progress.report(1);
    return result;
}

FinalContour finalContour(const WorkPlan& plan, const TurningSetup& setup, const std::vector<CutPlan>* targets)
{
    TurningWork work(plan, setup);
    TargetContour asked(plan);
    std::vector<Station> stations;
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
        work.take(plan.cuts[i], CutTask::Predict, stations);
        asked.take(targets ? (*targets)[i] : plan.cuts[i], stations, targets ? &setup : nullptr);
    }
    return asked.against(plan, work);
}

}  // namespace lathelier::deflection
