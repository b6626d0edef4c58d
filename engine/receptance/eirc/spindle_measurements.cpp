#include "engine/receptance/eirc/spindle_measurements.h"

#include <algorithm>
#include <map>
#include <set>

#include "engine/core/units.h"
#include "engine/io/json/json_fields.h"
#include "engine/receptance/receptance_codes.h"

namespace lathelier::receptance {
namespace {

Label required(Text name, Text help, Text unit = {})
{
    Label result{name, help, unit};
    result.required = true;
    return result;
}

/// Key of the file, of a rod and of a point: the nearest one counts.
template <class P>
Field<P> massField(Text help)
{
    return field("accelerometer_mass_g", &P::accelerometer_mass_g, Range{0, 1000},
                 Label{LT_TEXT("Engine", "Accelerometer"), help, LT_TEXT("Engine", "g")});
}

}  // namespace

std::int64_t MeasuredRod::nodeOf(std::size_t point) const
{
    return point < node.size() ? node[point] : static_cast<std::int64_t>(point) + 1;
}

double MeasuredRod::massAt(std::size_t point) const
{
    return point < accelerometer_mass_g.size() ? accelerometer_mass_g[point] : 0;
}

const std::vector<Field<RodPoint>>& fieldsOf(const RodPoint*)
{
    static const auto all = described<RodPoint>(
        field("node", &RodPoint::node, {-2147483647, 2147483647},
              required(LT_TEXT("Engine", "Node"), LT_TEXT("Engine", "Of the point in the file of responses."))),
        field("distance_from_chuck_mm", &RodPoint::distance_from_chuck_mm, {0, 1e5},
              required(LT_TEXT("Engine", "From the chuck"), LT_TEXT("Engine", "Along the rod."), unit::mm)),
        massField<RodPoint>(LT_TEXT("Engine", "Mass that moves with this point where it responds.")));
    return all;
}

const std::vector<Field<RodEntry>>& fieldsOf(const RodEntry*)
{
    static const auto all = described<RodEntry>(
        field("length_mm", &RodEntry::length_mm, {1e-3, 1e5},
              required(LT_TEXT("Engine", "Length"), LT_TEXT("Engine", "Outside the chuck."), unit::mm)),
        field("diameter_mm", &RodEntry::diameter_mm, {1e-3, 1e5},
              required(LT_TEXT("Engine", "Diameter"), LT_TEXT("Engine", "Of the cylinder."), unit::mm)),
        group("material", &RodEntry::material,
              Label{LT_TEXT("Engine", "Material"), LT_TEXT("Engine", "Stated for this rod.")}),
        massField<RodEntry>(LT_TEXT("Engine", "Mass that moves with the point of this rod that responds.")),
        rows("points", &RodEntry::points, {1, 1000},
             required(LT_TEXT("Engine", "Points"), LT_TEXT("Engine", "Where the rod is tapped and measured."))));
    return all;
}

const std::vector<Field<MeasurementFile>>& fieldsOf(const MeasurementFile*)
{
    static const auto all = described<MeasurementFile>(
        field("frf", &MeasurementFile::frf,
              required(LT_TEXT("Engine", "Responses"), LT_TEXT("Engine", "File of the frequency responses."))),
        field("averages", &MeasurementFile::averages, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Averages"),
                    LT_TEXT("Engine",
                            "Taps averaged for each response; with the coherence they give its noise. 0: not known.")}),
        massField<MeasurementFile>(LT_TEXT("Engine", "Mass that moves with the point that responds.")),
        rows("rods", &MeasurementFile::rods, {1, 100},
             required(LT_TEXT("Engine", "Rods"), LT_TEXT("Engine", "Measured in the chuck, one after the other."))));
    return all;
}

MeasurementFile readMeasurements(const std::string& json, Notes& notes)
{
    const io::JsonDocument document{json};
    auto file = io::readFields<MeasurementFile>(document.root(), notes);
    for (std::size_t rod = 0; rod < file.rods.size(); ++rod)
        for (std::size_t point = 0; point < file.rods[rod].points.size(); ++point)
            if (file.rods[rod].points[point].distance_from_chuck_mm > file.rods[rod].length_mm)
                throw Error(errors::measuredPointBeyondRod,
                            {{"rod", static_cast<std::int64_t>(rod) + 1},
                             {"point", static_cast<std::int64_t>(point) + 1},
                             {"node", std::int64_t{file.rods[rod].points[point].node}},
                             {"distance_mm", file.rods[rod].points[point].distance_from_chuck_mm},
                             {"length_mm", file.rods[rod].length_mm}});
    return file;
}

SpindleMeasurements measurementsOf(const MeasurementFile& file, std::span<const NodeFrf> frfs)
{
    struct Place {
        std::size_t rod, point;
    };
    SpindleMeasurements result;
    result.averages = file.averages;
    std::map<std::int64_t, Place> places;
    for (std::size_t rod = 0; rod < file.rods.size(); ++rod) {
        const RodEntry& entry = file.rods[rod];
        MeasuredRod measured;
        measured.shaft.segments = {{entry.length_mm, entry.diameter_mm, entry.diameter_mm, 0, std::nullopt, ""}};
        measured.shaft.material = entry.material;
        for (std::size_t point = 0; point < entry.points.size(); ++point) {
            const RodPoint& stated = entry.points[point];
            measured.distance_from_chuck_mm.push_back(stated.distance_from_chuck_mm);
            measured.node.push_back(stated.node);
            const auto& of_rod = entry.accelerometer_mass_g ? entry.accelerometer_mass_g : file.accelerometer_mass_g;
            measured.accelerometer_mass_g.push_back(stated.accelerometer_mass_g.value_or(of_rod.value_or(0)));
            places.emplace(stated.node, Place{rod, point});
        }
        result.rods.push_back(std::move(measured));
    }
    std::set<std::int64_t> seen;
    for (const NodeFrf& one : frfs) {
        const auto a = places.find(one.response_node);
        const auto b = places.find(one.reference_node);
        if (a == places.end() || b == places.end() || a->second.rod != b->second.rod) continue;
        seen.insert({one.response_node, one.reference_node});
        result.frfs.push_back({a->second.rod, a->second.point, b->second.point, one.frf});
    }
    for (const auto& [node, place] : places)
        if (!seen.contains(node))
            throw Error(errors::measuredNodeMissing,
                        {{"rod", static_cast<std::int64_t>(place.rod) + 1}, {"node", node}});
    return result;
}

}  // namespace lathelier::receptance
