#include "engine/features/nominal/roles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/features/nominal/nominal_limits.h"
#include "engine/features/nominal/suggestions.h"

namespace lathelier::features {
namespace {

/// Is this boundary of row i an end of the part, or a shoulder that falls further?
bool isFallingAway(const RowChain& chain, std::size_t i, bool at_start)
{
    const Joint joint = chain.joint(at_start ? i : i + 1);
    if (joint == Joint::End) return at_start ? chain.startsAtEnd() : chain.endsAtEnd();
    if (joint != Joint::Plane && joint != Joint::Relieved) return false;
    return at_start ? chain.endHeight_mm(i - 1) < chain.startHeight_mm(i)
                    : chain.startHeight_mm(i + 1) < chain.endHeight_mm(i);
}

/// Is the lower edge of row i at an end or a falling shoulder, and the upper one joined to a row?
bool isBreakingEdge(const RowChain& chain, std::size_t i)
{
    const bool rises = chain.endHeight_mm(i) > chain.startHeight_mm(i);
    const std::size_t upper = rises ? i + 1 : i;
    return isFallingAway(chain, i, rises) && (chain.joint(upper) == Joint::Joined || chain.isRoughSeam(upper));
}

/// Is the arc's lowest or highest point inside the row?
bool turns(const RowChain& chain, std::size_t i)
{
    const double start = chain.start_mm(i), length = chain.length_mm(i);
    const double at = (chain.piece(i).centre_mm().x() - start) / length;
    return at > roleLimits.arc_end_share && at < 1 - roleLimits.arc_end_share;
}

std::string roleOfCone(const RowChain& chain, std::size_t i)
{
    const double radial = std::abs(chain.endHeight_mm(i) - chain.startHeight_mm(i)) / 2, angle = chain.angle_deg(i);
    const RecognizedRow& row = chain.row(i);
    if (std::min(row.start_diameter_mm, row.end_diameter_mm) < roleLimits.no_diameter_mm || radial == 0) return "";
    if (angle > roleLimits.shallowest_chamfer_deg && angle < roleLimits.steepest_chamfer_deg &&
        std::min(radial, std::abs(chain.length_mm(i))) <= roleLimits.largest_leg_mm && isBreakingEdge(chain, i))
        return "chamfer";
    return "taper";
}

std::string roleOfArc(const RowChain& chain, std::size_t i)
{
    const RecognizedRow& row = chain.row(i);
    if (std::min(row.start_diameter_mm, row.end_diameter_mm) < roleLimits.no_diameter_mm) return "";
    const bool inside = turns(chain, i);
    if (chain.isConcave(i)) return inside ? "saddle" : "fillet";
    if (inside || std::abs(*row.arc_radius_mm) > roleLimits.largest_round_mm) return "";
    const bool between = chain.joint(i) == Joint::Joined && chain.joint(i + 1) == Joint::Joined;
    return between || isBreakingEdge(chain, i) ? "edge_round" : "";
}

/// Is a row along such a mark part of it: its crests, its corners, its own round?
bool isWholeRow(MarkKind kind)
{
    return kind == MarkKind::Thread || kind == MarkKind::Knurl || kind == MarkKind::Spline ||
           kind == MarkKind::Hexagon || kind == MarkKind::Square || kind == MarkKind::Eccentric;
}

/// The mark all around that covers most of a row; nullptr: none.
const ShaftMark* markOn(const RecognizedRow& row, const std::vector<ShaftMark>& marks)
{
    if (row.kind != RowKind::Cylinder) return nullptr;
    for (const ShaftMark& mark : marks) {
        if (!isWholeRow(mark.kind) || !mark.z_start_mm || !mark.z_end_mm) continue;
        const double common = std::min(row.z_end_mm, *mark.z_end_mm) - std::max(row.z_start_mm, *mark.z_start_mm);
        if (common > roleLimits.covered_share * (row.z_end_mm - row.z_start_mm)) return &mark;
    }
    return nullptr;
}

void setRole(std::vector<RecognizedRow>& rows, std::size_t first, std::size_t last, const char* role)
{
    for (std::size_t i = first; i <= last; ++i) rows[i].role = role;
}

/// Roles of the rows of a contour; `chain` looks at `rows`.
Patterns fillRoles(std::vector<RecognizedRow>& rows, const RowChain& chain,
                   const std::vector<const ShaftMark*>& mark_of)
{
    Patterns patterns;
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].role = mark_of[i] ? key(*mark_of[i]) : "";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto undercut = undercutRowsAt(chain, i);
        if (!undercut || !rows[undercut->bottom].role.empty()) continue;
        setRole(rows, undercut->first, undercut->last, "undercut");
        patterns.undercuts.push_back(*undercut);
        i = undercut->last;
    }
    // A groove begins behind the row that another one may begin with: edges of grooves are theirs only when joined.
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto groove = grooveRowsAt(chain, i);
        if (!groove) continue;
        setRole(rows, groove->first, groove->last, "groove");
        patterns.grooves.push_back(*groove);
        i = groove->last;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i].role.empty()) continue;
        if (rows[i].kind == RowKind::Cone) rows[i].role = roleOfCone(chain, i);
        if (rows[i].kind == RowKind::Arc) rows[i].role = roleOfArc(chain, i);
    }
    return patterns;
}

std::string designationIn(const RecognizedRow& row)
{
    for (const Suggestion& one : row.suggestions)
        if (!one.designation.empty()) return one.designation;
    return "";
}

std::vector<std::int64_t> numbersOf(std::size_t first, std::size_t last)
{
    std::vector<std::int64_t> numbers(last - first + 1);
    std::iota(numbers.begin(), numbers.end(), static_cast<std::int64_t>(first + 1));
    return numbers;
}

/// "0.2…0.4": range of the leg of an edge break.
std::string rangeOfLeg(const RowChain& chain, std::size_t i)
{
    const double radial = std::abs(chain.endHeight_mm(i) - chain.startHeight_mm(i)) / 2;
    const double leg = (std::abs(chain.length_mm(i)) + radial) / 2;
    const auto tenths = [](double value_mm) { return std::max(0.0, std::round(value_mm * 10) / 10); };
    return fmt::format("{}…{}", tenths(leg - roleLimits.uncertain_leg_mm), tenths(leg + roleLimits.uncertain_leg_mm));
}

std::vector<RecognizedFeature> featuresOf(const RowChain& chain, const Patterns& patterns, bool named)
{
    std::vector<RecognizedFeature> features;
    std::vector<bool> is_wall(chain.size() + 1, false);
    const auto add = [&](const char* kind, std::size_t first, std::size_t last, std::string designation) {
        features.push_back({kind, chain.start_mm(first), chain.closing_mm(last), numbersOf(first, last),
                            named ? std::move(designation) : std::string()});
    };
    for (const UndercutRows& undercut : patterns.undercuts) {
        add("undercut", undercut.first, undercut.last, designationIn(chain.row(undercut.arc)));
        if (!undercut.before_face) features.back().z_start_mm = chain.end_mm(undercut.first - 1);
    }
    for (const GrooveRows& groove : patterns.grooves) {
        const bool standard = groove.between_planes && groove.bottom;
        add("groove", groove.first, groove.last, standard ? designationIn(chain.row(*groove.bottom)) : "");
        is_wall[groove.first] = is_wall[groove.last + 1] = true;
    }
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const RecognizedRow& row = chain.row(i);
        const bool edge = row.role == "chamfer" || row.role == "edge_round";
        if (edge && isEdgeBreak(chain, i))
            add("edge_break", i, i, rangeOfLeg(chain, i));
        else if (row.role == "chamfer" || row.role == "taper" || row.role == "fillet")
            add(row.role.c_str(), i, i, designationIn(row));
        else if (row.role == "edge_round")
            add("fillet", i, i, designationIn(row));
        const Joint joint = chain.joint(i + 1);
        const bool relieved_face = chain.length_mm(i) < 0;
        if ((joint != Joint::Plane && joint != Joint::Relieved && !relieved_face) || is_wall[i + 1]) continue;
        if (i + 1 >= chain.size() || chain.isRoughSeam(i + 1)) continue;
        const double z = chain.closing_mm(i);
        features.push_back({"shoulder", z, z, numbersOf(i, i + 1), ""});
    }
    std::stable_sort(features.begin(), features.end(), [](const RecognizedFeature& a, const RecognizedFeature& b) {
        return a.z_start_mm < b.z_start_mm;
    });
    return features;
}

Patterns describe(std::vector<RecognizedRow>& rows, const RowChain& chain, const std::vector<const ShaftMark*>& mark_of,
                  bool suggest)
{
    for (RecognizedRow& row : rows) row.suggestions.clear();
    Patterns patterns = fillRoles(rows, chain, mark_of);
    if (!suggest) return patterns;
    auto threads = mark_of;
    for (const ShaftMark*& mark : threads)
        if (mark && mark->kind != MarkKind::Thread) mark = nullptr;
    auto suggestions = suggestionsFor(chain, patterns, threads);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].suggestions = std::move(suggestions[i]);
    return patterns;
}

}  // namespace

void describeRows(Recognition& recognition)
{
    const bool suggest = recognition.parameters.snap != Snap::None;
    recognition.features.clear();
    if (!recognition.segments.empty()) {
        std::vector<const ShaftMark*> mark_of;
        for (const RecognizedRow& row : recognition.segments) mark_of.push_back(markOn(row, recognition.marks));
        const RowChain chain(recognition);
        const Patterns patterns = describe(recognition.segments, chain, mark_of, suggest);
        recognition.features = featuresOf(chain, patterns, suggest);
    }
    for (std::size_t bore = 0; bore < recognition.bores.size(); ++bore) {
        std::vector<RecognizedRow>& rows = recognition.bores[bore];
        if (rows.empty()) continue;
        describe(rows, RowChain(recognition, bore), std::vector<const ShaftMark*>(rows.size(), nullptr), suggest);
    }
    for (ShaftMark& mark : recognition.marks) {
        if (!suggest || mark.kind != MarkKind::Thread || !mark.designation.empty() || !mark.pitch_mm || !mark.major_mm)
            continue;
        double U_mm = 0;
        for (const RecognizedRow& row : recognition.segments)
            if (markOn(row, {mark})) U_mm = diameterUncertainty_mm(row);
        if (const auto thread = suggestThread(*mark.major_mm, U_mm, *mark.pitch_mm))
            mark.designation = thread->designation;
    }
}

}  // namespace lathelier::features
