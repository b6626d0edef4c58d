#include "engine/stability/pass/lobes_over_pass.h"

#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/stability/pass/cut_shaft.h"
#include "engine/stability/refusal.h"

namespace lathelier::stability {
namespace {

void checkPass(const PassParameters& p, const LobeParameters& lobes)
{
    if (p.pass_z_mm.size() != 1)
        refuse("pass_z_mm", Value(p.pass_z_mm), LT_TEXT("Engine", "the stretch that the tool cuts, such as 0:100"));
    if (!(p.pass_z_mm.front().from < p.pass_z_mm.front().to))
        refuse("pass_z_mm", Value(p.pass_z_mm), LT_TEXT("Engine", "a range such as 0:100"));
    if (!p.pass_depth_mm) refuse("pass_depth_mm", Value(), LT_TEXT("Engine", "the depth of cut of the pass"));
    if (!lobes.cutting_coefficient_N_mm2)
        refuse("cutting_coefficient_N_mm2", Value(), LT_TEXT("Engine", "the cutting coefficient for a pass"));
    if (lobes.speed_rpm.size() != 1)
        refuse("speed_rpm", Value(lobes.speed_rpm), LT_TEXT("Engine", "one range of speeds"));
}

}  // namespace

const std::vector<Field<PassParameters>>& fieldsOf(const PassParameters*)
{
    using P = PassParameters;
    static const std::vector<Field<P>> all{
        field("pass_z_mm", &P::pass_z_mm, Range{0, 1e5},
              Label{LT_TEXT("Engine", "Pass"),
                    LT_TEXT("Engine",
                            "Stretch that the tool cuts, 0:100 from the free end toward the chuck: lobes for each "
                            "place."),
                    unit::mm}),
        field("pass_depth_mm", &P::pass_depth_mm, Range{1e-6, 1e4},
              Label{LT_TEXT("Engine", "Depth of the pass"),
                    LT_TEXT("Engine", "On the radius; the shaft is thinner by it behind the tool."), unit::mm}),
        field("pass_stations", &P::pass_stations, Range{2, 1000},
              Label{LT_TEXT("Engine", "Stations of the pass"),
                    LT_TEXT("Engine", "Places of the tool, evenly over the pass."),
                    {},
                    true})};
    return all;
}

PassResult lobesOverPass(const Shaft& stock, const PassParameters& parameters,
                         const receptance::ReceptanceParameters& receptance, const receptance::ShaftHolding& holding,
                         const LobeParameters& lobes, const Progress& progress)
{
    checkPass(parameters, lobes);
    cutShaft(stock, parameters.pass_z_mm.front().from, parameters.pass_z_mm.front().to, *parameters.pass_depth_mm);
    PassResult result;
    result.parameters = parameters;
    UsedValues used;
    const Material material = receptance::materialOf(stock, used, result.notes);
    const Interval pass = parameters.pass_z_mm.front();
    const auto rows = static_cast<std::size_t>(parameters.pass_stations);
    const auto columns = static_cast<std::size_t>(lobes.points);
    result.limit_mm.assign(rows * columns, notANumber);
    result.worst = {{},
                    std::vector<double>(columns, notANumber),
                    std::vector<double>(columns, notANumber),
                    std::vector<int>(columns, -1)};
    result.worst_z_mm.assign(columns, notANumber);
    result.stations.reserve(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        const double share = static_cast<double>(row) / static_cast<double>(rows - 1);
        const Progress part = progress.part(share, share);
        part.report(0);
        const double z_mm = row + 1 == rows ? pass.to : pass.from + share * (pass.to - pass.from);
        const Shaft now = cutShaft(stock, pass.from, z_mm, *parameters.pass_depth_mm);
        PassStation station{z_mm, diameterAt_mm(stock, z_mm) - 2 * *parameters.pass_depth_mm};
        receptance::ReceptanceParameters at_tool = receptance;
        at_tool.respond_z_mm = at_tool.excite_z_mm = z_mm;
        LobeParameters asked = lobes;
        if (asked.process_damping_N_mm) asked.diameter_mm = station.diameter_mm;
        const Frf frf = receptance::receptanceOf(now, material, at_tool, holding, part, receptance::LinesOf::Refined);
        const LobeLimit limit = limitOf(frf, asked, part);
        if (row == 0) result.speed_rpm = result.worst.speed_rpm = limit.speed_rpm;
        for (std::size_t i = 0; i < columns; ++i) {
            const double depth = limit.depth_mm[i];
            result.limit_mm[row * columns + i] = depth;
            if (limit.k[i] < 0) continue;
            if (!station.minimum_mm || depth < *station.minimum_mm) station.minimum_mm = depth;
            if (result.worst.k[i] >= 0 && depth >= result.worst.depth_mm[i]) continue;
            result.worst.depth_mm[i] = depth;
            result.worst.frequency_hz[i] = limit.frequency_hz[i];
            result.worst.k[i] = limit.k[i];
            result.worst_z_mm[i] = z_mm;
        }
        result.stations.push_back(station);
    }
    progress.report(1);
    return result;
}

}  // namespace lathelier::stability
