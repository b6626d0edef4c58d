#include "engine/cam/plan_head.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/cam/cutting_data.h"
#include "engine/cam/job_library.h"
#include "engine/cam/post/cut_off_stop.h"
#include "engine/cam/speed_words.h"
#include "engine/core/version.h"

namespace lathelier::cam {
namespace {

constexpr std::size_t mostHeadRests = 12;

std::string toolLine(const JobTool& tool)
{
    if (tool.isBlade())
        return fmt::format("T{} {} w{:g} c{:g}", tool.number, tool.name, *tool.width_mm, tool.radius_mm());
    if (tool.isThreader()) return fmt::format("T{} {} thread", tool.number, tool.name);
    if (tool.isDrill()) return fmt::format("T{} {} centre drill", tool.number, tool.name);
    return fmt::format("T{} {} r{:g} {:g} deg", tool.number, tool.name, tool.radius_mm(),
                       tool.entering_angle_deg.value_or(90));
}

}  // namespace

std::vector<std::string> headComments(const HeadFacts& facts, const Post&)
{
    const Job& job = facts.clamping.job;
    std::vector<std::string> lines{fmt::format("Lathelier {}", programVersion)};
    lines.insert(lines.end(), facts.origin.begin(), facts.origin.end());
    if (facts.setups > 1) lines.push_back(fmt::format("clamping {} of {}", facts.setup, facts.setups));
    lines.push_back(fmt::format("bar D{:g}, face {:g}, chuck at Z{:g}", job.stock.diameter_mm,
                                job.stock.face_allowance_mm, -job.setup.chuck_face_z_mm));
    if (facts.clamping.cut_off_to_mm) lines.push_back(cutOffComment(*facts.clamping.cut_off_to_mm));
    lines.push_back(facts.clamping.is_mirrored ? "Z0 other end face, finished" : "Z0 free end face, finished");
    if (job.setup.tailstock)
        lines.push_back(fmt::format("tailstock, centre hole D{:g}", job.setup.tailstock->centre_hole_mm));
    for (const JobTool& tool : job.tools) lines.push_back(toolLine(tool));
    for (const SectionSpeed& section : facts.sections) {
        if (!section.speed_rpm) continue;
        std::string line =
            fmt::format("S{:.0f}: z {:g}-{:g}", *section.speed_rpm, section.z_start_mm, section.z_end_mm);
        if (section.frequency_hz) line += fmt::format(", f_m {:.0f} Hz", *section.frequency_hz);
        if (section.lobe > 0) line += fmt::format(", lobe {}", section.lobe);
        if (section.reason == LT_TEXT("Engine", "no stable speed, that of the job is kept"))
            line += ", no stable speed";
        lines.push_back(line);
        if (section.stable_depth_mm)
            lines.push_back(fmt::format("  there depths up to {:.3f} mm are stable", *section.stable_depth_mm));
    }
    if (std::any_of(facts.sections.begin(), facts.sections.end(),
                    [](const SectionSpeed& section) { return section.speed_rpm.has_value(); }))
        lines.push_back(fmt::format("assumed: spindle ramp {:g} rpm/s", spindleRamp_rpm_s));
    if (facts.rest.empty()) lines.emplace_back("not reachable: nothing");
    for (std::size_t i = 0; i < std::min(facts.rest.size(), mostHeadRests); ++i)
        lines.push_back(fmt::format("not reachable: z {:.2f}-{:.2f} {:.3f} {}", facts.rest[i].z_start_mm,
                                    facts.rest[i].z_end_mm, facts.rest[i].left_mm, key(facts.rest[i].cause)));
    if (facts.rest.size() > mostHeadRests)
        lines.push_back(fmt::format("and {} more", facts.rest.size() - mostHeadRests));
    for (std::size_t i = 0; i < std::min(facts.not_made.size(), mostHeadRests); ++i)
        lines.push_back("not in the program: " + plainText(facts.not_made[i]));
    if (facts.not_made.size() > mostHeadRests)
        lines.push_back(fmt::format("and {} more", facts.not_made.size() - mostHeadRests));
    if (!job.max_rpm) lines.emplace_back("assumed: speed limit");
    for (const JobTool& tool : job.tools)
        if (isHolderAssumed(tool))
            lines.push_back(fmt::format("assumed: T{} outline of {}", tool.number, tool.holder_name));
    if (const auto* material = workMaterial(job.cutting.material))
        lines.push_back(fmt::format("assumed: {} k_c1.1 {:g}, m_c {:g}", material->value.name,
                                    material->value.k_c11_N_mm2, material->value.m_c));
    lines.push_back(facts.check.empty() ? "check: -" : facts.check);
    return lines;
}

void setMeasured(std::vector<Unreached>& predicted, const std::vector<RestInterval>& measured)
{
    for (Unreached& rest : predicted) {
        double left = 0;
        for (const RestInterval& other : measured)
            if (other.z_start_mm <= rest.z_end_mm && other.z_end_mm >= rest.z_start_mm)
                left = std::max(left, other.left_mm);
        if (left > 0) rest.left_mm = left;
    }
}

std::string checkLine(const CheckResult& check)
{
    return fmt::format("check: gouge {:.1f} um, {} findings, left {:.3f}", check.gouge_um, check.findings.size(),
                       check.left_max_mm);
}

}  // namespace lathelier::cam
