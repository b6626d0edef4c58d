#include "engine/chain/held_bar.h"

#include <algorithm>

#include "engine/cam/job_bodies.h"

namespace lathelier::chain {

HeldBar firstBar(const cam::Job& job)
{
    return {cam::heldStock(job), job.stock.face_allowance_mm, false};
}

std::optional<HeldBar> secondBar(const Shaft& part, const cam::Job& job)
{
    const auto split = cam::splitOf(part);
    double missing_mm = 0;
    const auto grip = split ? cam::gripBefore(part, job, *split, missing_mm) : std::nullopt;
    if (!grip) return std::nullopt;
    const cam::Clamping second = cam::twoClampings(part, job, *split, *grip).back();
    const double raw_mm = second.finished_to_mm, face_mm = second.job.setup.chuck_face_z_mm;
    Shaft finished = cam::cutAt(cam::mirrored(part), face_mm);
    Shaft bar = finished;
    bar.bores.clear();
    bar.marks.clear();
    ShaftSegment raw;
    const double before_face_mm = second.job.stock.face_allowance_mm;
    raw.length_mm = before_face_mm + std::min(raw_mm, face_mm);
    raw.start_diameter_mm = raw.end_diameter_mm = job.stock.diameter_mm;
    bar.segments = {raw};
    double begin_mm = 0;
    for (ShaftSegment row : finished.segments) {
        const double end_mm = begin_mm + row.length_mm;
        if (end_mm > raw_mm + 1e-9) {
            if (begin_mm < raw_mm) {
                const double share = (raw_mm - begin_mm) / row.length_mm;
                row.start_diameter_mm += share * (row.end_diameter_mm - row.start_diameter_mm);
                row.length_mm = end_mm - raw_mm;
                row.arc_radius_mm.reset();
            }
            bar.segments.push_back(row);
        }
        begin_mm = end_mm;
    }
    return HeldBar{std::move(bar), before_face_mm, true};
}

deflection::TurningSetup setupFor(deflection::TurningSetup setup, const HeldBar& held, const std::string& bar_file)
{
    setup.z_zero_mm = held.z_zero_mm;
    setup.stock = bar_file;
    if (held.is_mirrored) {
        setup.tailstock.reset();
        setup.steady_rests.clear();  // their positions refer to the first clamping
    }
    return setup;
}

}  // namespace lathelier::chain
