#include "engine/features/nominal/suggestions.h"

#include <algorithm>
#include <cmath>

#include "engine/features/nominal/nominal_limits.h"

namespace lathelier::features {
namespace {

bool isCovered(const RecognizedRow& row)
{
    return row.coverage_deg >= nominalLimits.least_coverage_deg;
}

Surface surfaceOf(const RowChain& chain)
{
    return chain.isBore() ? Surface::Bore : Surface::Outer;
}

void append(std::vector<Suggestion>& list, std::optional<Suggestion> one)
{
    if (one) list.push_back(std::move(*one));
}

Suggestion standardSize(std::string_view quantity, Measured measured, double nominal_mm, std::string designation)
{
    Suggestion one;
    one.quantity = quantity;
    one.measured_mm = measured.value_mm;
    one.nominal_mm = nominal_mm;
    one.difference_um = 1000 * (measured.value_mm - nominal_mm);
    one.designation = std::move(designation);
    one.agrees = true;  // measured sizes are those of the standard within its tolerances
    return one;
}

void suggestTaper(const RowChain& chain, std::size_t i, std::vector<Suggestion>& list)
{
    const RecognizedRow& row = chain.row(i);
    const bool grows = row.end_diameter_mm > row.start_diameter_mm;
    const double large = std::max(row.start_diameter_mm, row.end_diameter_mm);
    const double small = std::min(row.start_diameter_mm, row.end_diameter_mm);
    for (Suggestion& one : suggestTapers(
             {chain.angle_deg(i), row.uncertainty.angle_deg.value_or(0), small, large, std::abs(chain.length_mm(i))}))
        list.push_back(std::move(one));
    // Where the large end meets a cylinder, the diameter is that of the cylinder.
    const Joint joint = chain.joint(grows ? i + 1 : i);
    const auto& U_um = grows ? row.uncertainty.end_diameter_um : row.uncertainty.start_diameter_um;
    if (joint == Joint::Plane || joint == Joint::End)
        append(list, suggestDiameter(large, U_um.value_or(0) / 1000, surfaceOf(chain)));
}

/// Suggestions by row while they are found.
struct RowSuggestions {
    std::vector<std::vector<Suggestion>> of_row;
    std::vector<bool> settled;  ///< rows whose sizes a pattern has given
    std::vector<bool> has_z;    ///< rows whose end is a baseline dimension

    explicit RowSuggestions(std::size_t n) : of_row(n), settled(n, false), has_z(n, true) {}
};

void suggestUndercuts(const RowChain& chain, const std::vector<UndercutRows>& undercuts, RowSuggestions& found)
{
    for (const UndercutRows& rows : undercuts) {
        const auto standard = undercutOf(rows.measured);
        if (!standard || !isCovered(chain.row(rows.arc))) continue;
        found.of_row[rows.arc].push_back(standardSize("undercut", rows.measured.radius, standard->radius_mm,
                                                      designationOf(*standard, rows.measured.form)));
        for (std::size_t i = rows.first; i <= rows.last; ++i) found.settled[i] = true;
    }
}

void suggestGrooves(const RowChain& chain, const std::vector<GrooveRows>& grooves, RowSuggestions& found)
{
    for (const GrooveRows& groove : grooves) {
        if (!groove.between_planes || !groove.bottom || !isCovered(chain.row(*groove.bottom))) continue;
        const RecognizedRow& row = chain.row(*groove.bottom);
        const Measured bottom{row.start_diameter_mm, diameterUncertainty_mm(row)};
        std::vector<Suggestion>& list = found.of_row[*groove.bottom];
        const auto circlip = chain.isBore() ? std::nullopt : circlipGrooveOf(groove.shaft, bottom, groove.width);
        if (circlip) {
            const std::string name = designationOf(*circlip);
            list.push_back(standardSize("diameter_mm", bottom, circlip->groove_mm, name));
            list.back().fits = fitsOf(bottom.value_mm, bottom.U_mm, circlip->groove_mm);
            list.back().tolerance = circlipBottomClass(*circlip);
            list.push_back(standardSize("length_mm", groove.width, circlip->width_mm, name));
        } else {
            append(list, suggestDiameter(bottom.value_mm, bottom.U_mm, surfaceOf(chain)));
            append(list, suggestLength(groove.width.value_mm, groove.width.U_mm));
        }
        found.settled[*groove.bottom] = true;
        found.has_z[groove.last] = list.empty() || list.back().quantity != "length_mm";
    }
}

/// Of a row that no pattern has settled.
void suggestSizes(const RowChain& chain, std::size_t i, const ShaftMark* thread, std::vector<Suggestion>& list)
{
    const RecognizedRow& row = chain.row(i);
    if (row.kind == RowKind::Cylinder) {
        const double expanded_mm = diameterUncertainty_mm(row);
        std::optional<Suggestion> found;
        if (thread && thread->pitch_mm)
            found = suggestThread(thread->major_mm.value_or(row.start_diameter_mm), expanded_mm, *thread->pitch_mm);
        if (!found) found = suggestDiameter(row.start_diameter_mm, expanded_mm, surfaceOf(chain));
        append(list, found);
    } else if (row.role == "chamfer" && !isEdgeBreak(chain, i)) {
        append(list, suggestChamfer(std::abs(chain.length_mm(i)), lengthUncertainty_mm(row), chain.angle_deg(i),
                                    row.uncertainty.angle_deg.value_or(0)));
    } else if (row.role == "taper") {
        suggestTaper(chain, i, list);
    } else if (row.kind == RowKind::Arc && row.fully_visible && !(row.role == "edge_round" && isEdgeBreak(chain, i))) {
        append(list, suggestRadius(*row.arc_radius_mm, row.uncertainty.arc_radius_um.value_or(0) / 1000));
    }
}

/// Does row i end at a plane that lengths are measured to?
bool endsAtDatum(const RowChain& chain, std::size_t i)
{
    const Joint joint = chain.joint(i + 1);
    const bool next_covered = i + 1 >= chain.size() || isCovered(chain.row(i + 1));
    const bool is_datum = joint == Joint::Plane || joint == Joint::Relieved ||
                          (joint == Joint::Joined && chain.length_mm(i) < 0) ||
                          (joint == Joint::End && (chain.endsAtEnd() || chain.isBore()));
    return is_datum && next_covered && !chain.isRoughSeam(i + 1);
}

}  // namespace

bool isEdgeBreak(const RowChain& chain, std::size_t i)
{
    const double radial = std::abs(chain.endHeight_mm(i) - chain.startHeight_mm(i)) / 2;
    return std::max(std::abs(chain.length_mm(i)), radial) < roleLimits.smallest_shaped_edge_mm;
}

std::vector<std::vector<Suggestion>> suggestionsFor(const RowChain& chain, const Patterns& patterns,
                                                    const std::vector<const ShaftMark*>& thread_of)
{
    RowSuggestions found(chain.size());
    suggestUndercuts(chain, patterns.undercuts, found);
    suggestGrooves(chain, patterns.grooves, found);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        if (!isCovered(chain.row(i))) continue;
        std::vector<Suggestion>& list = found.of_row[i];
        if (!found.settled[i]) suggestSizes(chain, i, thread_of[i], list);
        if (found.has_z[i] && endsAtDatum(chain, i))
            append(list, suggestLength(chain.closing_mm(i), chain.boundaryUncertainty_mm(i + 1), "z_mm"));
    }
    return std::move(found.of_row);
}

}  // namespace lathelier::features
