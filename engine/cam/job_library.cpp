#include "engine/cam/job_library.h"

#include "engine/cam/cam_codes.h"
#include "engine/cam/plan_codes.h"

namespace lathelier::cam {
namespace {

using ToolEntry = LibraryEntry<cutting::LibraryTool>;

void fill(std::optional<double>& stated, const std::optional<double>& found)
{
    if (!stated) stated = found;
}

[[noreturn]] void refuseCode(const JobTool& tool, const std::string& found, const std::string& expected)
{
    throw Error(errors::toolNotInLibrary,
                {{"tool", std::int64_t{tool.number}}, {"found", found}, {"expected", expected}});
}

std::string keysOf(const std::vector<ToolEntry>& entries)
{
    std::string all;
    for (const ToolEntry& entry : entries) all += (all.empty() ? "" : ", ") + entry.key;
    return all;
}

}  // namespace

Job withLibrary(Job job, const cutting::ToolLibrary& library)
{
    for (JobTool& tool : job.tools) {
        if (!tool.insert.empty()) {
            const std::optional<cutting::LibraryTool> insert = cutting::insertNamed(tool.insert, library);
            if (!insert) refuseCode(tool, tool.insert, keysOf(library.inserts));
            fill(tool.corner_radius_mm, insert->corner_radius_mm);
            fill(tool.tip_angle_deg, insert->tip_angle_deg);
            fill(tool.edge_length_mm, insert->edge_length_mm);
        }
        if (!tool.holder_name.empty()) {
            const ToolEntry* holder = entryNamed(library.holders, tool.holder_name);
            if (!holder) refuseCode(tool, tool.holder_name, keysOf(library.holders));
            fill(tool.entering_angle_deg, holder->value.entering_angle_deg);
            if (tool.holder.empty()) tool.holder = holder->value.holder;
            if (holder->value.hand == Hand::FromChuck) tool.hand = Hand::FromChuck;
        }
        tool.settle();
    }
    return job;
}

void noteFits(const Job& job, Notes& notes)
{
    for (const JobTool& tool : job.tools)
        if (!tool.insert.empty() && !tool.holder_name.empty() && !cutting::fitsHolder(tool.insert, tool.holder_name))
            notes.push_back(
                {notes::insertNotOfHolder,
                 {{"tool", std::int64_t{tool.number}}, {"insert", tool.insert}, {"holder", tool.holder_name}}});
}

void noteLibrary(const Job& stated, Notes& notes)
{
    const auto add = [&](const JobTool& tool, Text what, const std::string& code, const std::string& standing,
                         const std::string& source) {
        notes.push_back({notes::toolFromLibrary,
                         {{"tool", std::int64_t{tool.number}},
                          {"what", what},
                          {"name", code},
                          {"standing", standing},
                          {"source", source}}});
    };
    for (const JobTool& tool : stated.tools) {
        if (!tool.insert.empty() && !(tool.corner_radius_mm && tool.tip_angle_deg && tool.edge_length_mm)) {
            const ToolEntry* entry = entryNamed(cutting::toolLibrary().inserts, tool.insert);
            // Geometry follows from ISO 1832; only the ranges of an insert are assumed.
            add(tool, LT_TEXT("Engine", "the geometry"), tool.insert, "given", entry ? entry->source : "ISO 1832");
        }
        const ToolEntry* holder = entryNamed(cutting::toolLibrary().holders, tool.holder_name);
        if (holder && (tool.holder.empty() || !tool.entering_angle_deg))
            add(tool, LT_TEXT("Engine", "the outline"), tool.holder_name, holder->value.standing, holder->source);
    }
}

bool isHolderAssumed(const JobTool& tool)
{
    const ToolEntry* holder = entryNamed(cutting::toolLibrary().holders, tool.holder_name);
    return holder && holder->value.standing == "assumed" && tool.holder == holder->value.holder;
}

void noteRanges(const Job& job, Notes& notes)
{
    for (const JobTool& tool : job.tools) {
        const bool rough = tool.use == ToolUse::Rough;
        if (tool.insert.empty() || !tool.isProfile()) continue;
        const std::optional<cutting::LibraryTool> insert = cutting::insertNamed(tool.insert);
        if (!insert) continue;
        const cutting::CuttingRanges& ranges = insert->ranges;
        const auto look = [&](Text quantity, double found, const std::optional<double>& low,
                              const std::optional<double>& high) {
            if ((!low || found >= *low) && (!high || found <= *high)) return;
            notes.push_back({notes::outsideRange,
                             {{"tool", std::int64_t{tool.number}},
                              {"quantity", quantity},
                              {"found", found},
                              {"low", low.value_or(0)},
                              {"high", high.value_or(found)},
                              {"standing", insert->standing}}});
        };
        const RoughCutting& cutting = job.cutting.rough;
        look(LT_TEXT("Engine", "a feed"),
             tool.feed_mm_rev.value_or(rough ? cutting.feed_mm_rev : job.cutting.finish.feed_mm_rev),
             ranges.feed_low_mm_rev, ranges.feed_high_mm_rev);
        look(LT_TEXT("Engine", "a cutting speed"),
             rough ? cutting.cutting_speed_m_min : job.cutting.finish.cutting_speed_m_min, ranges.speed_low_m_min,
             ranges.speed_high_m_min);
        if (rough)
            look(LT_TEXT("Engine", "a depth"), cutting.depth_mm, {}, ranges.depth_high_mm);
        else
            look(LT_TEXT("Engine", "an allowance"), cutting.allowance_mm, ranges.depth_low_mm, ranges.depth_high_mm);
    }
}

}  // namespace lathelier::cam
