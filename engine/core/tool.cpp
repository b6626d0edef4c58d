#include "engine/core/tool.h"

#include <algorithm>
#include <cctype>

#include "engine/core/units.h"

namespace lathelier {
namespace {

constexpr Range sizes_mm{0.01, 1000};

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

std::vector<Field<Tool>> namingFields()
{
    using T = Tool;
    return described<T>(
        field("number", &T::number, {0, 99999},
              Label{LT_TEXT("Engine", "Tool number"),
                    LT_TEXT("Engine", "As the program calls it; 0: every tool that is not listed.")}),
        field("kind", &T::kind,
              {{"insert", LT_TEXT("Engine", "insert with two edges")},
               {"round", LT_TEXT("Engine", "round insert")},
               {"blade", LT_TEXT("Engine", "blade")},
               {"drill", LT_TEXT("Engine", "drill on the axis")},
               {"boring_bar", LT_TEXT("Engine", "boring bar")},
               {"threading", LT_TEXT("Engine", "threading insert")}},
              Label{LT_TEXT("Engine", "Kind"), LT_TEXT("Engine", "What cuts.")}),
        field("name", &T::name, Label{LT_TEXT("Engine", "Name"), LT_TEXT("Engine", "Of insert and holder.")}),
        field("insert", &T::insert,
              Label{LT_TEXT("Engine", "Insert"), LT_TEXT("Engine", "ISO code from the library, such as CNMG 120408.")}),
        field("holder_name", &T::holder_name,
              Label{LT_TEXT("Engine", "Holder's code"),
                    LT_TEXT("Engine", "ISO code from the library, such as PCLNL 2525M12.")}),
        field("hand", &T::hand,
              {{"toward_chuck", LT_TEXT("Engine", "toward the chuck")},
               {"from_chuck", LT_TEXT("Engine", "from the chuck")}},
              Label{LT_TEXT("Engine", "Hand"), LT_TEXT("Engine", "Direction of its feed.")}),
        field("tip", &T::tip, {0, 9},
              Label{LT_TEXT("Engine", "Tip"),
                    LT_TEXT("Engine",
                            "Where the imaginary tip lies seen from the nose centre, as Fanuc counts: 3 towards the "
                            "axis and the chuck.")}));
}

std::vector<Field<Tool>> sizeFields()
{
    using T = Tool;
    return described<T>(
        // Older writers put a corner radius of 0, that of a blade, beside the nose radius of an insert.
        formerly({.key = "nose_radius_mm", .blank = 0},
                 field("corner_radius_mm", &T::corner_radius_mm, {0, 100},
                       Label{LT_TEXT("Engine", "Corner radius"),
                             LT_TEXT("Engine", "Of the corner that cuts; of both corners of a blade."), unit::mm})),
        formerly({.key = "lead_angle_deg", .complement = 90},
                 field("entering_angle_deg", &T::entering_angle_deg, {1, 178},
                       Label{LT_TEXT("Engine", "Entering angle"),
                             LT_TEXT("Engine", "Between main edge and feed: 90° less the lead angle."), unit::deg})),
        field("tip_angle_deg", &T::tip_angle_deg, {1, 180},
              Label{LT_TEXT("Engine", "Tip angle"),
                    LT_TEXT("Engine", "Between both edges: C 80°, D 55°, V 35°; of a drill, its point."), unit::deg}),
        field("edge_length_mm", &T::edge_length_mm, sizes_mm,
              Label{LT_TEXT("Engine", "Length of the edge"), LT_TEXT("Engine", "Of an insert."), unit::mm}),
        field("width_mm", &T::width_mm, sizes_mm,
              Label{LT_TEXT("Engine", "Width"), LT_TEXT("Engine", "Of a blade."), unit::mm}),
        field("diameter_mm", &T::diameter_mm, sizes_mm,
              Label{LT_TEXT("Engine", "Diameter"), LT_TEXT("Engine", "Of a drill."), unit::mm}),
        formerly({.key = "max_depth_mm"},
                 field("reach_mm", &T::reach_mm, sizes_mm,
                       Label{LT_TEXT("Engine", "Reach"),
                             LT_TEXT("Engine", "How deep a blade cuts, on radius; length of a drill or a boring bar."),
                             unit::mm})));
}

}  // namespace

const std::vector<Field<HolderCorner>>& fieldsOf(const HolderCorner*)
{
    using H = HolderCorner;
    static const auto all = described<H>(
        field("dz_mm", &H::dz_mm, {-1e4, 1e4},
              Label{LT_TEXT("Engine", "From the tip along z"), LT_TEXT("Engine", "Toward the chuck."), unit::mm}),
        field("dx_mm", &H::dx_mm, {-1e4, 1e4},
              Label{LT_TEXT("Engine", "From the tip along x"), LT_TEXT("Engine", "Away from the axis."), unit::mm}));
    return all;
}

const std::vector<Field<Tool>>& fieldsOf(const Tool*)
{
    using T = Tool;
    static const auto all = described<T>(
        namingFields(), sizeFields(),
        field(
            "shank_width_mm", &T::shank_width_mm, {0, 500},
            Label{LT_TEXT("Engine", "Width of the shank"),
                  LT_TEXT("Engine", "A shank across the axis behind the insert; empty: the insert alone."), unit::mm}),
        rows("holder", &T::holder, {0, 1000},
             Label{LT_TEXT("Engine", "Holder"),
                   LT_TEXT("Engine", "Corners from the tip; their convex hull must not meet stock.")}));
    return all;
}

std::string plainCode(const std::string& name)
{
    std::string result;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::optional<double> tipAngleOfCode_deg(std::string_view code)
{
    struct Letter {
        char letter;
        double angle_deg;
    };
    static constexpr Letter letters[] = {{'A', 85}, {'B', 82}, {'C', 80}, {'D', 55}, {'E', 75}, {'K', 55},
                                         {'M', 86}, {'S', 90}, {'T', 60}, {'V', 35}, {'W', 80}};
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (code.size() < 4 || !std::all_of(code.begin(), code.begin() + 4, is_capital)) return {};
    const std::string_view rest = code.substr(4);
    const std::size_t digit = rest.find_first_not_of(' ');
    if (digit == std::string_view::npos || !isDigit(rest[digit])) return {};
    for (const Letter& one : letters)
        if (one.letter == code.front()) return one.angle_deg;
    return {};
}

std::optional<Tool> toolOfCode(const std::string& code)
{
    constexpr std::size_t codeLetters = 4, codeDigits = 6;  // "CNMG 120408": C is the shape, 12 the edge, 08 the corner
    const std::string plain = plainCode(code);
    if (plain.size() < codeLetters + codeDigits) return {};
    std::string upper(plain);
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const auto number = [&](std::size_t at) {
        return isDigit(plain[at]) && isDigit(plain[at + 1]) ? 10 * (plain[at] - '0') + (plain[at + 1] - '0') : 0;
    };
    const std::optional<double> tip_deg = tipAngleOfCode_deg(upper);
    const int edge_mm = number(codeLetters), tenths = number(codeLetters + 4);
    if (!tip_deg || edge_mm == 0 || tenths == 0) return {};
    constexpr double tenthsPerMillimetre = 10;
    Tool tool;
    tool.corner_radius_mm = tenths / tenthsPerMillimetre;
    tool.tip_angle_deg = tip_deg;
    tool.edge_length_mm = edge_mm;
    return tool;
}

}  // namespace lathelier
