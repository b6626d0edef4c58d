#include "app/cli/shafts.h"

#include "engine/beam/beam_codes.h"
#include "engine/io/file.h"
#include "engine/io/json/json_locate.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/io/text/encoding.h"
#include "engine/receptance/spindle_file.h"

namespace lathelier::cli {
namespace {

/// Files that options name.
struct ShaftFiles {
    std::string material;  ///< path; empty: as the shaft states
    std::string spindle;   ///< path; empty: the shaft is free
};

const std::vector<Field<ShaftFiles>>& fieldsOf(const ShaftFiles*)
{
    static const std::vector<Field<ShaftFiles>> all{
        field("material", &ShaftFiles::material,
              Label{LT_TEXT("Engine", "Material"), LT_TEXT("Engine", "Of the shaft, from FILE.json.")}),
        field(
            "spindle", &ShaftFiles::spindle,
            Label{LT_TEXT("Engine", "Spindle"),
                  LT_TEXT("Engine", "The machine at the chuck face, from FILE.json; without it the shaft is free.")})};
    return all;
}

/// Calls `read` with the text of the file; its errors get the path.
template <class Read>
auto readText(const std::string& path, io::InputFiles& inputs, const Progress& progress, Read read)
{
    try {
        return read(inputs.open(path, progress));
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace

std::string wordOf(const Request& request, const char* key)
{
    const Value* const value = find(request.parameters, key);
    const auto* const text = value ? std::get_if<std::string>(value) : nullptr;
    return text ? *text : std::string();
}

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

std::vector<Option> shaftOptions()
{
    std::vector<Option> options = optionsOf<receptance::ReceptanceParameters>();
    for (Option& option : optionsOf<ShaftFiles>()) options.push_back(std::move(option));
    return options;
}

Shaft readShaft(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
                Answer& answer)
{
    Shaft shaft = readText(path, inputs, progress,
                           [&](std::string_view text) { return io::readShaftFile(text, answer.notes, progress); });
    if (const std::string material = wordOf(request, "material"); !material.empty())
        shaft.material = readText(material, inputs, progress, [&](std::string_view text) {
            return io::readMaterial(std::string(text), answer.notes);
        });
    return shaft;
}

std::optional<receptance::SpindleReceptance> readSpindle(const Request& request, io::InputFiles& inputs,
                                                         const Progress& progress, Answer& answer)
{
    const std::string path = wordOf(request, "spindle");
    if (path.empty()) return std::nullopt;
    return readText(path, inputs, progress,
                    [&](std::string_view text) { return receptance::readSpindle(std::string(text), answer.notes); });
}

}  // namespace lathelier::cli
