#include "app/cli/any_shaft.h"

#include <nlohmann/json.hpp>
#include <string>

#include "engine/cad/shaft_csv.h"
#include "engine/cad/step_reader.h"
#include "engine/io/file_kind.h"
#include "engine/io/json/json_head.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/io/text/encoding.h"

namespace lathelier::cli {

Shaft readAnyShaft(std::string_view bytes, Notes& notes, Json& facts, const Progress& progress)
{
    const std::string_view head = bytes.substr(0, 4096);
    if (cad::looksLikeStep(head)) {
        cad::StepPart part = cad::readStep(bytes, notes, progress);
        facts["format"] = "STEP";
        facts["axis"] = {{"point_mm", {part.free_end_mm.x(), part.free_end_mm.y(), part.free_end_mm.z()}},
                         {"direction", {part.axis.x(), part.axis.y(), part.axis.z()}}};
        facts["solid_volume_mm3"] = part.volume_mm3;
        facts["other_faces"] = Json::array();
        for (const cad::OtherFace& face : part.other_faces)
            facts["other_faces"].push_back({{"kind", face.kind.english},
                                            {"area_mm2", face.area_mm2},
                                            {"z_start_mm", face.z_start_mm},
                                            {"z_end_mm", face.z_end_mm}});
        return part.shaft;
    }
    const io::DecodedText text = io::decodeText(bytes, io::Encoding::Auto, progress);
    const std::size_t first = text.view().find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && text.view()[first] == '{') {
        facts["format"] = "shaft_json";
        return io::readShaft(std::string(text.view()), notes);
    }
    facts["format"] = "csv";
    return cad::readShaftCsv(bytes, notes, progress);
}

bool isDrawnShaft(std::string_view bytes)
{
    const std::string_view head = bytes.substr(0, io::headForKind);
    if (cad::looksLikeStep(head)) return true;
    const std::vector<std::string> keys = io::keysOfHead(head);
    return io::hasKey(keys, "segments") && !io::hasKey(keys, "command");
}

}  // namespace lathelier::cli
