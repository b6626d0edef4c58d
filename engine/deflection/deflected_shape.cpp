#include "engine/deflection/deflected_shape.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::deflection {
namespace {

}  // namespace

DeflectedShape deflectedShape(const WorkPlan& plan, const TurningSetup& setup, std::size_t pass, double z_mm)
{
    TurningWork work(plan, setup);
    std::vector<Station> stations;
    std::size_t index = 0, seen = 0;
    for (;; ++index) {
        TurningWork trial = work;
        trial.take(plan.cuts.at(index), CutTask::Predict, stations);
        if (!stations.empty() && seen++ == pass) break;
        work = trial;
    }
    CutPlan cut = plan.cuts[index];
    const auto distance = [&](const Station& a, const Station& b) {
        return std::abs(a.z_mm - z_mm) < std::abs(b.z_mm - z_mm);
    };
    const Station tool = *std::min_element(stations.begin(), stations.end(), distance);
    const std::size_t pieces = tool.piece + (tool.at_start ? 0 : 1);
    const std::size_t node = cut.first + pieces;
    cut.pieces.resize(pieces);
    work.take(cut, CutTask::Predict, stations);

    DeflectedShape shape;
    shape.tool_z_mm = tool.z_mm;
    shape.forces = tool.forces;
    shape.z_mm = plan.z_mm;
    const double arm_mm = setup.feed_moment ? tool.stock_mm - tool.depth_mm / 2 : 0;
    const std::vector<Motion2> x = work.shapeUnder(node, {-tool.forces.F_ap_N, -tool.forces.F_f_N * arm_mm});
    const std::vector<Motion2> y = work.shapeUnder(node, {tool.forces.F_t_N, 0});
    shape.x_um.reserve(x.size());
    shape.y_um.reserve(y.size());
    for (const Motion2& motion : x) shape.x_um.push_back(um_per_mm * motion.w);
    for (const Motion2& motion : y) shape.y_um.push_back(um_per_mm * motion.w);
    return shape;
}

}  // namespace lathelier::deflection
