#include "engine/cad/task/compare_inputs.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "engine/cad/step_kind.h"
#include "engine/core/json.h"
#include "engine/io/cloud/unit_choice.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/registration/verdict/zones_input.h"
#include "engine/shaft/shaft_rules.h"
#include "engine/task/read_key.h"

namespace lathelier::cad {
namespace {

constexpr const char* unitKey = "unit";  // of io::ImportOptions

void setUnit(project::Source& source, io::LengthUnit unit)
{
    io::ImportOptions options;
    options.unit = unit;
    if (unit != io::LengthUnit::Auto) set(source.import, unitKey, *find(toValues(options), unitKey));
}

/// Size of a shaft as io::sizeOf_mm() has it for points on its surface.
double sizeOf_mm(const Shaft& shaft)
{
    double area = 0, radii = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        const double radius_mm = (segment.start_diameter_mm + segment.end_diameter_mm) / 4;
        area += radius_mm * segment.length_mm;
        radii += radius_mm * radius_mm * radius_mm * segment.length_mm;
    }
    const double length_mm = shaft.length_mm();
    return area > 0 ? std::sqrt(length_mm * length_mm / 12 + radii / area) : 0;
}

/// Of a pipe it is not known what it holds before it is read, which is possible once.
struct PipedReference {
    struct File {
        std::optional<PartFile> part;  ///< none: a scan
        io::ScanFile scan;
        Notes notes;
    };
    using Value = File;
    static constexpr const char* item = "";

    static File read(const io::FileToRead& file)
    {
        File loaded;
        if (isDrawing(file.bytes)) {
            loaded.part = PartInput::read(file);
            loaded.notes = loaded.part->notes;
        } else {
            loaded.scan = io::ScanInput::read(file);
            loaded.notes = loaded.scan.notes;
        }
        return loaded;
    }
    static Value valueOf(const File& file) { return file; }
    static io::FileKinds kinds() { return {}; }
};

bool isPipe(const project::Source& source)
{
    std::error_code ignored;
    return source.item.empty() && std::filesystem::is_fifo(source.path, ignored);
}

void takePiped(const project::PanelState& state, Stores& stores, task::Sources& sources, const Progress& progress,
               ReferenceTaken& taken)
{
    const auto loaded = task::takeFile<PipedReference>(state, referenceRole, stores, progress, sources);
    if (!loaded->file.part) {
        taken.scan = std::make_shared<const LoadedScan>(LoadedScan{loaded->file.scan, loaded->inputs});
        return;
    }
    PartTaken part;
    part.shaft = loaded->file.part->shaft;
    part.file = std::make_shared<const Loaded<PartFile>>(Loaded<PartFile>{*loaded->file.part, loaded->inputs});
    taken.drawn = std::make_shared<const PartTaken>(std::move(part));
}

/// A drawing that is checked.
void checkDrawn(const PartTaken& drawn, const project::Source& source, task::Sources& sources)
{
    try {
        const Notes remarks = checkShaft(drawn.shaft);
        dropRepeated(sources, remarks);
        sources.notes.insert(sources.notes.end(), remarks.begin(), remarks.end());
    } catch (Error& error) {
        locatePart(error, source);
        throw;
    }
}

void readReference(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const project::Source* const source = task::sourceOf(state, referenceRole);
    if (!source || isPipe(*source)) return;
    task::Sources unused;
    if (isDrawn(*source))
        task::takeFile<PartInput>(state, referenceRole, stores, progress, unused);
    else
        task::takeFile<io::ScanInput>(state, referenceRole, stores, progress, unused);
}

}  // namespace

project::PanelState withUnits(project::PanelState state, const CompareQuestion& question)
{
    for (auto& [key, source] : state.inputs) {
        if (key == referenceRole) setUnit(source, question.reference_unit);
        if (key == copyRole || project::belongsTo(key, copiesRole)) setUnit(source, question.copy_unit);
    }
    return state;
}

project::PanelState withStatedUnits(project::PanelState state)
{
    const auto given = [&](const char* role) {
        const Value* const unit = find(state.inputs.at(role).import, unitKey);
        return unit ? *unit : *find(toValues(io::ImportOptions{}), unitKey);
    };
    const Value of_reference = given(referenceRole), of_copy = given(copyRole);
    if (of_reference == of_copy) return state;
    for (auto& [key, source] : state.inputs)
        std::erase_if(source.import, [](const auto& one) { return one.first == unitKey; });
    set(state.parameters, referenceUnitKey, of_reference);
    set(state.parameters, copyUnitKey, of_copy);
    return state;
}

bool isDrawn(const project::Source& source)
{
    if (!source.item.empty()) return true;
    try {
        return isDrawing(io::fileHead(source.path, io::headForKind));
    } catch (const Error&) {  // its reader says why
        return false;
    }
}

ReferenceTaken takeReference(const project::PanelState& state, Stores& stores, task::Sources& sources,
                             const Progress& progress)
{
    const project::Source& source = state.inputs.at(referenceRole);
    ReferenceTaken taken;
    const std::size_t first = sources.inputs.size();
    if (isPipe(source))
        takePiped(state, stores, sources, progress, taken);
    else if (isDrawn(source))
        taken.drawn = std::make_shared<const PartTaken>(takePart(state, referenceRole, stores, sources, progress));
    else
        taken.scan = task::takeFile<io::ScanInput>(state, referenceRole, stores, progress, sources);
    if (taken.drawn) checkDrawn(*taken.drawn, source, sources);
    taken.key = task::readKey(state, {referenceRole}, sources, first);
    return taken;
}

void explain(Error& error, const project::PanelState& state, const ReferenceTaken& reference, const Scan& copy,
             Notes& notes)
{
    if (error.code().kind == ErrorKind::NoAnswer) {
        const double reference_mm =
            reference.drawn ? sizeOf_mm(reference.drawn->shaft) : io::sizeOf_mm(reference.scan->file.scan.points_mm);
        const double copy_mm = io::sizeOf_mm(copy.points_mm);
        if (const auto factor = io::unitFactorBetween(reference_mm, copy_mm))
            notes.push_back({notes::unitsMayDiffer, {{"factor", *factor}, {"size_ratio", copy_mm / reference_mm}}});
    }
    const Value* const role = find(error.values(), "role");
    const auto* const name = role ? std::get_if<std::string>(role) : nullptr;
    if (name) error.with("path", task::nameOf(state.inputs.at(*name == copyRole ? copyRole : referenceRole)));
}

std::vector<task::Input> compareInputs()
{
    std::vector<task::Input> inputs;
    inputs.push_back(task::input<PartInput>(
        referenceRole, "", LT_TEXT("Engine", "Reference"),
        LT_TEXT("Engine",
                "The original: a point cloud or mesh; or its drawing: a STEP file or SHAFT.json (mm). A "
                "drawing adds the sizes row by row.")));
    inputs.back().kinds = {&io::scanFiles(), &stepFiles(), &io::shaftFiles()};
    inputs.back().read = readReference;
    inputs.push_back(task::ofPart(task::input<io::ScanInput>(copyRole, "", LT_TEXT("Engine", "Copy"),
                                                             LT_TEXT("Engine", "The copy: a point cloud or mesh."))));
    inputs.push_back(task::optionalInput<io::ScanInput>(
        copiesRole, "", LT_TEXT("Engine", "Further copies"),
        LT_TEXT("Engine", "Scans of more parts, judged by the same limits: table and trend")));
    inputs.back().several = true;
    inputs.back().is_of_part = true;
    inputs.back().in_window_only = true;
    inputs.push_back(task::optionalInput<registration::ZonesInput>(
        zonesRole, zonesKey, LT_TEXT("Engine", "Zones"),
        LT_TEXT("Engine", "Limits of their own along the axis, from FILE.json.")));
    return inputs;
}

}  // namespace lathelier::cad
