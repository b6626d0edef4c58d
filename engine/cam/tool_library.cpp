#include "engine/cam/tool_library.h"

#include <algorithm>
#include <cctype>

#include "engine/cam/cam_codes.h"
#include "engine/cam/cutting_data.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/post/built_in_posts.h"
#include "engine/cam/required_label.h"
#include "engine/core/units.h"
#include "engine/io/json/library_file.h"

namespace lathelier::cam {
namespace {

constexpr Range lengths_mm{0, 1000};

/// "CNMG 120408": C is the shape, 12 the edge, 08 the corner in 0.1 mm.
std::optional<LibraryInsert> insertOfCode(const std::string& code)
{
    const std::string plain = plainName(code);
    constexpr std::size_t codeLetters = 4, codeDigits = 6;
    if (plain.size() < codeLetters + codeDigits) return {};
    std::string upper(plain);
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const std::optional<double> tip = stock::tipAngleOfCode_deg(upper);
    const auto number = [&](std::size_t at) -> std::optional<int> {
        if (!std::isdigit(static_cast<unsigned char>(plain[at])) ||
            !std::isdigit(static_cast<unsigned char>(plain[at + 1])))
            return {};
        return 10 * (plain[at] - '0') + (plain[at + 1] - '0');
    };
    const std::optional<int> edge = number(codeLetters), corner = number(codeLetters + 4);
    if (!tip || !edge || !corner || *edge == 0 || *corner == 0) return {};
    LibraryInsert insert;
    insert.tip_angle_deg = *tip;
    insert.edge_length_mm = *edge;
    constexpr double tenthsPerMillimetre = 10;
    insert.corner_radius_mm = *corner / tenthsPerMillimetre;
    insert.standing = "given";
    return insert;
}

void fill(std::optional<double>& stated, const std::optional<double>& found)
{
    if (!stated) stated = found;
}

[[noreturn]] void refuseCode(const JobTool& tool, const std::string& found, const std::string& expected)
{
    throw Error(errors::toolNotInLibrary,
                {{"tool", std::int64_t{tool.number}}, {"found", found}, {"expected", expected}});
}

template <class T>
const LibraryEntry<T>* entryNamed(const std::vector<LibraryEntry<T>>& library, const std::string& code)
{
    for (const LibraryEntry<T>& entry : library)
        if (plainName(entry.key) == plainName(code)) return &entry;
    return nullptr;
}

const LibraryEntry<LibraryInsert>* listedInsert(const std::string& code)
{
    return entryNamed(libraryInserts(), code);
}

const LibraryEntry<LibraryHolder>* listedHolder(const std::string& code)
{
    return entryNamed(libraryHolders(), code);
}

template <class T>
std::string keysOf(const std::vector<LibraryEntry<T>>& library)
{
    std::string all;
    for (const LibraryEntry<T>& entry : library) all += (all.empty() ? "" : ", ") + entry.key;
    return all;
}

}  // namespace

const std::vector<Field<LibraryInsert>>& fieldsOf(const LibraryInsert*)
{
    using I = LibraryInsert;
    const Text help = LT_TEXT("Engine", "Range for it.");
    static const auto all = described<I>(
        field("corner_radius_mm", &I::corner_radius_mm, {0, 100},
              required(LT_TEXT("Engine", "Nose radius"), LT_TEXT("Engine", "Of the insert."), unit::mm)),
        field("tip_angle_deg", &I::tip_angle_deg, {1, 180},
              required(LT_TEXT("Engine", "Tip angle"), LT_TEXT("Engine", "Of the insert."), unit::deg)),
        field("lead_angle_deg", &I::lead_angle_deg, {-89, 89},
              Label{LT_TEXT("Engine", "Lead angle"), LT_TEXT("Engine", "On its usual holder."), unit::deg}),
        field("edge_length_mm", &I::edge_length_mm, lengths_mm,
              Label{LT_TEXT("Engine", "Length of the edge"), LT_TEXT("Engine", "Of the insert."), unit::mm}),
        field("depth_low_mm", &I::depth_low_mm, lengths_mm, Label{LT_TEXT("Engine", "Least depth"), help, unit::mm}),
        field("depth_high_mm", &I::depth_high_mm, lengths_mm,
              Label{LT_TEXT("Engine", "Largest depth"), help, unit::mm}),
        field("feed_low_mm_rev", &I::feed_low_mm_rev, {0, 100},
              Label{LT_TEXT("Engine", "Least feed"), help, unit::mm_rev}),
        field("feed_high_mm_rev", &I::feed_high_mm_rev, {0, 100},
              Label{LT_TEXT("Engine", "Largest feed"), help, unit::mm_rev}),
        field("speed_low_m_min", &I::speed_low_m_min, {0, 1e5},
              Label{LT_TEXT("Engine", "Least cutting speed"), help, unit::m_min}),
        field("speed_high_m_min", &I::speed_high_m_min, {0, 1e5},
              Label{LT_TEXT("Engine", "Largest cutting speed"), help, unit::m_min}),
        field("standing", &I::standing, Label{LT_TEXT("Engine", "Standing"), LT_TEXT("Engine", "Given or assumed.")}));
    return all;
}

const std::vector<Field<LibraryHolder>>& fieldsOf(const LibraryHolder*)
{
    using H = LibraryHolder;
    static const auto all = described<H>(
        field("name", &H::name, Label{LT_TEXT("Engine", "Name"), LT_TEXT("Engine", "ISO code.")}),
        field("entering_angle_deg", &H::entering_angle_deg, {1, 178},
              required(LT_TEXT("Engine", "Entering angle"), LT_TEXT("Engine", "Of the main edge."), unit::deg)),
        field("hand", &H::hand,
              {{"toward_chuck", LT_TEXT("Engine", "toward the chuck")},
               {"from_chuck", LT_TEXT("Engine", "from the chuck")}},
              Label{LT_TEXT("Engine", "Hand"), LT_TEXT("Engine", "Direction of its feed.")}),
        rows("holder", &H::holder, {0, 1000},
             Label{LT_TEXT("Engine", "Holder"), LT_TEXT("Engine", "Corners from the tip.")}),
        field("standing", &H::standing, Label{LT_TEXT("Engine", "Standing"), LT_TEXT("Engine", "Given or assumed.")}));
    return all;
}

const std::vector<LibraryEntry<LibraryInsert>>& libraryInserts()
{
    static const auto all = io::readLibrary<LibraryInsert>(builtInLibrary("inserts"), "inserts");
    return all;
}

const std::vector<LibraryEntry<LibraryHolder>>& libraryHolders()
{
    static const auto all = io::readLibrary<LibraryHolder>(builtInLibrary("holders"), "holders");
    return all;
}

std::optional<LibraryInsert> insertNamed(const std::string& code)
{
    if (const LibraryEntry<LibraryInsert>* entry = listedInsert(code)) return entry->value;
    return insertOfCode(code);
}

const LibraryHolder* holderNamed(const std::string& code)
{
    const LibraryEntry<LibraryHolder>* entry = listedHolder(code);
    return entry ? &entry->value : nullptr;
}

Job withLibrary(Job job)
{
    for (JobTool& tool : job.tools) {
        if (!tool.insert.empty()) {
            const std::optional<LibraryInsert> insert = insertNamed(tool.insert);
            if (!insert) refuseCode(tool, tool.insert, keysOf(libraryInserts()));
            fill(tool.nose_radius_mm, insert->corner_radius_mm);
            fill(tool.tip_angle_deg, insert->tip_angle_deg);
            fill(tool.edge_length_mm, insert->edge_length_mm);
        }
        if (tool.holder_name.empty()) continue;
        const LibraryHolder* holder = holderNamed(tool.holder_name);
        if (!holder) refuseCode(tool, tool.holder_name, keysOf(libraryHolders()));
        fill(tool.entering_angle_deg, holder->entering_angle_deg);
        if (tool.holder.empty()) tool.holder = holder->holder;
        if (holder->hand == Hand::FromChuck) tool.hand = Hand::FromChuck;
    }
    return job;
}

bool fitsHolder(const std::string& insert, const std::string& holder)
{
    // "cnmg120408", and "pclnl2525m12" or "sclcl2020k09": clamping, shape, style, clearance, hand, shank, length, edge.
    const std::string of = plainName(insert), to = plainName(holder);
    constexpr std::size_t codeLetters = 4, holderLetters = 5;
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    if (of.size() < codeLetters + 2 || to.size() < holderLetters + 2 || !isDigit(of[codeLetters]) ||
        !isDigit(to[holderLetters]))
        return true;
    if (of[0] != to[1] || of[1] != to[3]) return false;
    if (!isDigit(to[to.size() - 1]) || !isDigit(to[to.size() - 2])) return true;
    return of.compare(codeLetters, 2, to, to.size() - 2, 2) == 0;
}

void noteFits(const Job& job, Notes& notes)
{
    for (const JobTool& tool : job.tools)
        if (!tool.insert.empty() && !tool.holder_name.empty() && !fitsHolder(tool.insert, tool.holder_name))
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
        if (!tool.insert.empty() && !(tool.nose_radius_mm && tool.tip_angle_deg && tool.edge_length_mm)) {
            const LibraryEntry<LibraryInsert>* entry = listedInsert(tool.insert);
            // Geometry follows from ISO 1832; only the ranges of an insert are assumed.
            add(tool, LT_TEXT("Engine", "the geometry"), tool.insert, "given", entry ? entry->source : "ISO 1832");
        }
        const LibraryEntry<LibraryHolder>* holder = listedHolder(tool.holder_name);
        if (holder && (tool.holder.empty() || !tool.entering_angle_deg))
            add(tool, LT_TEXT("Engine", "the outline"), tool.holder_name, holder->value.standing, holder->source);
    }
}

bool isHolderAssumed(const JobTool& tool)
{
    const LibraryEntry<LibraryHolder>* holder = listedHolder(tool.holder_name);
    return holder && holder->value.standing == "assumed" && tool.holder == holder->value.holder;
}

void noteRanges(const Job& job, Notes& notes)
{
    for (const JobTool& tool : job.tools) {
        const bool rough = tool.use == ToolUse::Rough;
        if (tool.insert.empty() || !tool.isProfile()) continue;
        const std::optional<LibraryInsert> insert = insertNamed(tool.insert);
        if (!insert) continue;
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
             insert->feed_low_mm_rev, insert->feed_high_mm_rev);
        look(LT_TEXT("Engine", "a cutting speed"),
             rough ? cutting.cutting_speed_m_min : job.cutting.finish.cutting_speed_m_min, insert->speed_low_m_min,
             insert->speed_high_m_min);
        if (rough)
            look(LT_TEXT("Engine", "a depth"), cutting.depth_mm, {}, insert->depth_high_mm);
        else
            look(LT_TEXT("Engine", "an allowance"), cutting.allowance_mm, insert->depth_low_mm, insert->depth_high_mm);
    }
}

}  // namespace lathelier::cam
