#include "engine/deflection/deflection_question.h"

#include <algorithm>

#include "engine/core/field_within.h"
#include "engine/core/units.h"
#include "engine/cutting/tool_library.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/influences.h"
#include "engine/receptance/library.h"
#include "engine/receptance/receptance_codes.h"

namespace lathelier::deflection {
namespace {

constexpr double rightAngle_deg = 90;
constexpr double rigid_N_mm = 1e12;  ///< 1 kN causes 1 pm

Field<SetupChanges> change(const char* key, std::optional<double> SetupChanges::*member, Range range,
                           const Label& label)
{
    return field(key, member, range, label);
}

/// Selections from the libraries, and the user's insert.
std::vector<Field<SetupChanges>> libraryFields()
{
    using C = SetupChanges;
    const Text stated = LT_TEXT("Engine", "as the set-up states");
    return {choice("changed_insert", &C::insert, cutting::insertChoices(stated),
                   Label{LT_TEXT("Engine", "Insert"),
                         LT_TEXT("Engine",
                                 "Geometry from the library. The cutting coefficients, which belong to "
                                 "material and insert, stay those of the set-up.")}),
            choice("changed_machine", &C::machine, receptance::machineChoices(stated),
                   Label{LT_TEXT("Engine", "Machine"),
                         LT_TEXT("Engine", "Springs of the chuck from the library that the question Machine uses.")}),
            choice("changed_material", &C::material, receptance::materialChoices(stated),
                   Label{LT_TEXT("Engine", "Material"),
                         LT_TEXT("Engine",
                                 "Elastic constants from the library that the question Machine uses. The "
                                 "cutting coefficients stay those of the set-up.")}),
            change("changed_corner_radius_mm", &C::corner_radius_mm, {0.01, 100},
                   Label{LT_TEXT("Engine", "Corner radius"), LT_TEXT("Engine", "In place of the value in the set-up."),
                         unit::mm, true}),
            change("changed_lead_angle_deg", &C::lead_angle_deg, {-80, 80},
                   Label{LT_TEXT("Engine", "Lead angle"),
                         LT_TEXT("Engine", "The edge enters at 90° less this: -5° is an entering angle of 95°."),
                         unit::deg, true})};
}

/// Further supports beside chuck and tailstock.
std::vector<Field<SetupChanges>> restFields()
{
    using C = SetupChanges;
    const Label rests{LT_TEXT("Engine", "Steady rests"),
                      LT_TEXT("Engine", "Place and radial stiffness, in place of those in the set-up."),
                      {},
                      true};
    return {rows("changed_steady_rests", &C::steady_rests, Range{0, 20}, rests),
            change("changed_follower_N_mm", &C::follower_N_mm, {0, 1e12},
                   Label{LT_TEXT("Engine", "Follower rest, radial"),
                         LT_TEXT("Engine", "In place of the value in the set-up; 0: without one."), unit::N_mm, true}),
            change("changed_follower_offset_mm", &C::follower_offset_mm, {-1e5, 1e5},
                   Label{LT_TEXT("Engine", "Follower rest, distance from the tool"),
                         LT_TEXT("Engine", "Toward the chuck; negative: behind the tool, on the machined surface."),
                         unit::mm, true}),
            change("changed_post_radial_N_mm", &C::post_radial_N_mm, {0, 1e12},
                   Label{LT_TEXT("Engine", "Tool post, radial"),
                         LT_TEXT("Engine", "In place of the value in the set-up; 0: rigid."), unit::N_mm, true}),
            change("changed_post_tangential_N_mm", &C::post_tangential_N_mm, {0, 1e12},
                   Label{LT_TEXT("Engine", "Tool post, tangential"),
                         LT_TEXT("Engine", "In place of the value in the set-up; 0: rigid."), unit::N_mm, true})};
}

/// The follower rest with changes; an offset alone changes an existing one.
void changeFollower(std::optional<FollowerRest>& rest, const SetupChanges& changes)
{
    if (changes.follower_N_mm) {
        if (*changes.follower_N_mm <= 0) return rest.reset();
        if (!rest) rest.emplace();
        rest->radial_N_mm = *changes.follower_N_mm;
    }
    if (rest && changes.follower_offset_mm) rest->offset_mm = *changes.follower_offset_mm;
}

/// The tool post with changes; an unstated direction, or 0, is rigid.
void changePost(std::optional<ToolPost>& post, const SetupChanges& changes)
{
    const auto takeOver = [&post](const std::optional<double>& stated_N_mm, double ToolPost::*member) {
        if (!stated_N_mm) return;
        if (!post) post = ToolPost{rigid_N_mm, rigid_N_mm};
        (*post).*member = *stated_N_mm > 0 ? *stated_N_mm : rigid_N_mm;
    };
    takeOver(changes.post_radial_N_mm, &ToolPost::radial_N_mm);
    takeOver(changes.post_tangential_N_mm, &ToolPost::tangential_N_mm);
    if (post && post->radial_N_mm >= rigid_N_mm && post->tangential_N_mm >= rigid_N_mm) post.reset();
}

std::vector<Field<SetupChanges>> changeFields()
{
    const Text as_stated = LT_TEXT("Engine", "In place of the value in the set-up.");
    std::vector<Field<SetupChanges>> all{
        change("changed_tailstock_N_mm", &SetupChanges::tailstock_N_mm, {0, 1e12},
               Label{LT_TEXT("Engine", "Tailstock, radial"), as_stated, unit::N_mm}),
        change("changed_chuck_N_mm", &SetupChanges::chuck_N_mm, {1, 1e12},
               Label{LT_TEXT("Engine", "Chuck, radial"), as_stated, unit::N_mm}),
        change("changed_chuck_N_mm_rad", &SetupChanges::chuck_N_mm_rad, {1, 1e15},
               Label{LT_TEXT("Engine", "Chuck, tilting"), as_stated, LT_TEXT("Engine", "N·mm/rad")}),
        change("changed_forces_percent", &SetupChanges::forces_percent, {1, 1000},
               Label{LT_TEXT("Engine", "Cutting forces"), LT_TEXT("Engine", "Of those of the set-up."), unit::percent}),
        change("changed_z_zero_mm", &SetupChanges::z_zero_mm, {-1e5, 1e5},
               Label{LT_TEXT("Engine", "z of the program's zero"), as_stated, unit::mm, true})};
    for (const auto& made : {libraryFields(), restFields()}) all.insert(all.end(), made.begin(), made.end());
    return all;
}

/// Adds the fields of a member that are not there yet.
template <class Part>
void addFolded(std::vector<Field<DeflectionQuestion>>& all, Part DeflectionQuestion::*member)
{
    for (const FieldInfo& info : infos<Part>()) {
        const auto is = [&](const Field<DeflectionQuestion>& there) { return there.info.key == info.key; };
        if (std::none_of(all.begin(), all.end(), is)) all.push_back(foldedWithin(member, info.key));
    }
}

std::vector<Field<DeflectionQuestion>> questionFields()
{
    using Q = DeflectionQuestion;
    std::vector<Field<Q>> all{within(&Q::study, "tolerance_um")};
    for (const FieldInfo& info : infos<SetupChanges>()) all.push_back(within(&Q::changes, info.key));
    for (const char* key : {"measured", "band", "sensitivities", "feed", "map"}) all.push_back(within(&Q::study, key));
    all.push_back(within(&Q::map, "cutting_speed_m_min"));
    addFolded(all, &Q::study);
    addFolded(all, &Q::band);
    addFolded(all, &Q::map);
    addFolded(all, &Q::identification);
    addFolded(all, &Q::compensation);
    addFolded(all, &Q::reading);
    all.push_back(gcode::draftsField(&Q::drafts));
    return all;
}

void takeFromLibraries(TurningSetup& setup, const SetupChanges& changes, Notes& notes)
{
    if (const auto* const entry = entryOf(receptance::materials(), changes.material)) {
        setup.material.elastic = entry->value;
        notes.push_back({notes::materialOfLibrary,
                         {{"material", receptance::nameOfMaterial(entry->key)}, {"source", entry->source}}});
    }
    if (const auto* const entry = entryOf(receptance::machines(), changes.machine)) {
        setup.chuck.radial_N_mm = entry->value.radial_N_mm;
        setup.chuck.tilt_N_mm_rad = entry->value.tilt_N_mm_rad;
        notes.push_back({notes::machineOfLibrary, {{"source", entry->source}}});
    }
    if (const auto* const entry = entryOf(cutting::toolLibrary().inserts, changes.insert)) {
        // What the forces need; the edge of the check against stock stays assumed.
        Tool insert;
        insert.corner_radius_mm = entry->value.corner_radius_mm;
        insert.entering_angle_deg = entry->value.entering_angle_deg;
        insert.tip_angle_deg = entry->value.tip_angle_deg;
        setup.tool = insert;
        notes.push_back({notes::insertOfLibrary, {{"insert", entry->value.label}, {"source", entry->source}}});
    }
    if (changes.corner_radius_mm) setup.tool.corner_radius_mm = *changes.corner_radius_mm;
    if (changes.lead_angle_deg) setup.tool.entering_angle_deg = rightAngle_deg - *changes.lead_angle_deg;
}

}  // namespace

StudyDetails detailsOf(const DeflectionQuestion& q)
{
    return {q.band, q.map, {0, q.map.least_feed_mm_rev, q.map.largest_feed_mm_rev}, q.identification, q.compensation};
}

const std::vector<Field<SetupChanges>>& fieldsOf(const SetupChanges*)
{
    static const std::vector<Field<SetupChanges>> all = changeFields();
    return all;
}

const std::vector<Field<DeflectionQuestion>>& fieldsOf(const DeflectionQuestion*)
{
    static const std::vector<Field<DeflectionQuestion>> all = questionFields();
    return all;
}

TurningSetup changed(TurningSetup setup, const SetupChanges& changes, Notes& notes)
{
    takeFromLibraries(setup, changes, notes);
    if (changes.forces_percent) setup = scaled(std::move(setup), Influence::Forces, *changes.forces_percent / 100);
    if (changes.chuck_N_mm) setup.chuck.radial_N_mm = *changes.chuck_N_mm;
    if (changes.chuck_N_mm_rad) setup.chuck.tilt_N_mm_rad = *changes.chuck_N_mm_rad;
    if (changes.z_zero_mm) setup.z_zero_mm = *changes.z_zero_mm;
    if (changes.tailstock_N_mm) {
        if (!setup.tailstock) setup.tailstock.emplace();
        setup.tailstock->radial_N_mm = *changes.tailstock_N_mm;
        if (*changes.tailstock_N_mm <= 0) setup.tailstock.reset();
    }
    if (!changes.steady_rests.empty()) setup.steady_rests = changes.steady_rests;
    changeFollower(setup.follower_rest, changes);
    changePost(setup.tool_post, changes);
    return setup;
}

}  // namespace lathelier::deflection
