#include "engine/receptance/shaft/shaft_place.h"

#include "engine/beam/beam_codes.h"
#include "engine/io/file.h"
#include "engine/io/json/json_locate.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/io/text/encoding.h"

namespace lathelier::receptance {

void locateSegment(Error& error, const std::string& path, const Shaft& shaft)
{
    if (!(error.code() == errors::shaftSegmentUnusable)) return;
    try {
        const io::FileBytes bytes(path);
        Notes ignored;
        const io::DecodedText text = io::decodeText(bytes.view(), io::Encoding::Auto, {});
        const Shaft stated = io::readShaft(std::string(text.view()), ignored);
        if (stated.bores.empty() && stated.segments.size() == shaft.segments.size()) io::locateRow(error, path);
    } catch (const Error&) {
        // no SHAFT.json: its rows have no places
    }
    error.with("path", path);
}

}  // namespace lathelier::receptance
