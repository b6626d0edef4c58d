#include "engine/cam/check/second_work.h"

#include <algorithm>

#include "engine/cam/cam_codes.h"
#include "engine/cam/post/cut_off_stop.h"

namespace lathelier::cam {
namespace {

constexpr double leastStandingEnd_mm = 0.5;     // beyond the face allowance; less is residual material of the face
constexpr double leastStandingRadius_mm = 0.1;  // thinner ends are the nib of facing

}  // namespace

double workLength_mm(std::string_view program, double part_length_mm, const Job& job, const CheckParameters& parameters,
                     Notes& notes)
{
    const double face = job.stock.face_allowance_mm;
    if (parameters.work_length_mm) return *parameters.work_length_mm;
    if (const std::optional<double> stated = cutOffOf(program)) {
        notes.push_back({notes::workCutOff, {{"length_mm", *stated}}});
        return *stated;
    }
    if (job.part_off && !job.setup.tailstock) return part_length_mm + face;
    if (job.stock.length_mm) return *job.stock.length_mm - face;
    notes.push_back({notes::cutOffAssumed, {{"length_mm", part_length_mm + face}}});
    return part_length_mm + face;
}

std::optional<CheckFinding> standingEnd(const stock::StockResult& met, double zero_mm, double face_allowance_mm,
                                        const std::vector<gcode::Move>& moves)
{
    double begin = zero_mm, radius = 0;
    for (std::size_t i = 0; i < met.left.columns() && met.left.middle_mm(i) < zero_mm; ++i) {
        const double outer = met.left.outerRadius_mm(met.left.middle_mm(i)).value_or(0);
        if (outer < leastStandingRadius_mm) continue;
        begin = std::min(begin, met.left.middle_mm(i));
        radius = std::max(radius, outer);
    }
    if (zero_mm - begin < face_allowance_mm + leastStandingEnd_mm) return {};
    const auto cuts = [](const gcode::Move& move) {
        return move.kind == gcode::MoveKind::Feed || move.kind == gcode::MoveKind::Arc;
    };
    const auto first = std::find_if(moves.begin(), moves.end(), cuts);
    return CheckFinding{first == moves.end() ? 0 : first->line, CheckKind::StandingEnd, begin - zero_mm, radius,
                        zero_mm - begin};
}

}  // namespace lathelier::cam
