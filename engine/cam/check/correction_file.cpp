#include "engine/cam/check/correction_file.h"

#include "engine/io/json/json_document.h"

namespace lathelier::cam {
namespace {

constexpr std::size_t mostNodes = 1000000;

}  // namespace

gcode::StatedCorrection readCorrection(const std::string& json)
{
    const io::JsonDocument document{json};
    const Text number = LT_TEXT("Engine", "a number");
    std::vector<gcode::CorrectedCorner> corners;
    const io::JsonCursor nodes =
        document.root().at("nodes", LT_TEXT("Engine", "the corners that deflection --compensate states"));
    nodes.items(mostNodes, [&](const io::JsonCursor& node) {
        const double z = node.at("z_mm", number).number();
        corners.push_back({z, node.at("x_mm", number).number() - node.at("programmed_mm", number).number()});
    });
    return gcode::correctionOf(corners);
}

}  // namespace lathelier::cam
