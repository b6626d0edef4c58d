// Fanuc's other G code systems of turning: the letters of system A, but G90 … G99 and G70 mean something else. Programs
// of system B are rewritten for system A.
#include <algorithm>
#include <cctype>
#include <utility>

#include "engine/gcode/controls/controls.h"

namespace lathelier::gcode {
namespace {

/// The codes of system B replaced by those of system A: G90 is left out, G92 becomes G50, G94 and G95 become G98 and
/// G99, G33 becomes G32. Codes without a counterpart (G91) are unchanged and read as in system A. Comments stay.
std::string asSystemA(const std::string& text)
{
    static constexpr std::pair<const char*, const char*> codes[]{
        {"G90", ""}, {"G94", "G98"}, {"G95", "G99"}, {"G92", "G50"}, {"G33", "G32"}};
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '(') {
            const std::size_t end = std::min(text.find_first_of(")\n", at), text.size() - 1);
            result += text.substr(at, end + 1 - at);
            at = end + 1;
            continue;
        }
        const bool isWord = at + 2 < text.size() && text[at] == 'G' &&
                            (at + 3 >= text.size() || !std::isdigit(static_cast<unsigned char>(text[at + 3])));
        const auto* code = std::find_if(std::begin(codes), std::end(codes), [&](const auto& pair) {
            return isWord && text.compare(at, 3, pair.first) == 0;
        });
        if (code == std::end(codes)) {
            result += text[at++];
        } else {
            result += code->second;
            at += 3;
        }
    }
    return result;
}

}  // namespace

Control fanucB()
{
    Control control;
    control.key = "fanuc_b";
    control.label = LT_TEXT("Engine", "Fanuc (G code system B)");
    control.is_read = false;
    control.read_as = "fanuc";
    control.rewritten = asSystemA;
    control.evidence.variant_of = "fanuc";
    control.evidence.certain = 3;
    control.evidence.rank = 1;
    control.evidence.blocks = {{.points = 3, .g = {92}, .letters = "S", .none_of = "XZUW"},
                               {.points = 2, .g = {90, 91}, .none_of = "XZUW"},
                               {.points = 2, .g = {90, 91}, .also_g = {0, 1}, .one_of = "XZUW"},
                               {.points = 1, .g = {94, 95}, .none_of = "XZUW"},
                               {.points = 1, .g = {95}}};
    return control;
}

Control fanucC()
{
    Control control;
    control.key = "fanuc_c";
    control.label = LT_TEXT("Engine", "Fanuc (G code system C)");
    control.is_read = false;
    control.evidence.variant_of = "fanuc";
    control.evidence.certain = 4;
    control.evidence.rank = 2;
    control.evidence.blocks = {{.points = 2, .g = {70, 71}, .none_of = "XZUWPD"},
                               {.points = 5, .g = {20, 21}, .no_g = {0, 1}, .letters = "F", .one_of = "XZUW"}};
    return control;
}

}  // namespace lathelier::gcode
