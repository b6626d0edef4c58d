#include "engine/deflection/written_contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lathelier::deflection {
namespace {

constexpr double rounding = 1e-12;  ///< mm

/// Candidate corner at one grid radius.
struct Candidate {
    double x_mm = 0;
    double squares_mm2 =
        std::numeric_limits<double>::infinity();  ///< sum of squared distances at the corners up to here
    std::size_t corners =
        std::numeric_limits<std::size_t>::max();         ///< number of corners of the shortest chain up to here
    std::size_t before_place = 0, before_candidate = 0;  ///< predecessor in that chain
    std::vector<ArcEnd> arcs;                            ///< from there to here; empty: a line

    bool isReached() const { return corners != std::numeric_limits<std::size_t>::max(); }
};

std::vector<Candidate> candidatesAt(double x_mm, double grid_mm, double tolerance_mm)
{
    std::vector<Candidate> result;
    const double first = std::ceil((x_mm - tolerance_mm - rounding) / grid_mm);
    const double last = std::floor((x_mm + tolerance_mm + rounding) / grid_mm);
    for (double k = first; k <= last; ++k) {
        result.emplace_back();
        result.back().x_mm = k * grid_mm;
    }
    return result;
}

/// Where the radius is free: some to either side.
std::vector<Candidate> freeCandidatesAt(double x_mm, double grid_mm)
{
    constexpr std::array beside_mm{0.0, -0.002, 0.002, -0.005, 0.005, -0.01, 0.01, -0.02, 0.02};
    std::vector<Candidate> result(beside_mm.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i].x_mm = std::round((x_mm + beside_mm[i]) / grid_mm) * grid_mm;
    return result;
}

/// Takes a way to a candidate if it has fewer corners, or the same number and lies nearer.
bool isShorter(const Candidate& to, std::size_t corners, double squares_mm2)
{
    return corners < to.corners || (corners == to.corners && squares_mm2 < to.squares_mm2);
}

}  // namespace

std::optional<std::vector<WrittenCorner>> writtenContour(const std::vector<WantedPlace>& wanted,
                                                         const std::vector<WantedArc>& arcs, const ArcLimits& limits)
{
    const std::size_t count = wanted.size();
    const double tolerance_mm = limits.tolerance_mm;
    if (count == 0) return std::vector<WrittenCorner>{};
    std::vector<std::vector<Candidate>> at;
    at.reserve(count);
    for (const WantedPlace& place : wanted)
        at.push_back(place.is_free ? freeCandidatesAt(place.x_mm, limits.grid_mm)
                                   : candidatesAt(place.x_mm, limits.grid_mm, tolerance_mm));
    for (Candidate& start : at.front()) {
        start.corners = 1;
        start.squares_mm2 = (start.x_mm - wanted.front().x_mm) * (start.x_mm - wanted.front().x_mm);
    }
    auto nextArc = arcs.begin();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        while (nextArc != arcs.end() && nextArc->last <= i) ++nextArc;
        const bool is_arc = nextArc != arcs.end() && nextArc->first <= i;
        if (is_arc && nextArc->first < i) continue;
        for (std::size_t c = 0; c < at[i].size(); ++c) {
            const Candidate from = at[i][c];
            if (!from.isReached()) continue;
            const auto reach = [&](Candidate& to, std::size_t j, std::size_t corners, std::vector<ArcEnd> ends) {
                const double off_mm = to.x_mm - wanted[j].x_mm;
                const double squares_mm2 = from.squares_mm2 + off_mm * off_mm;
                if (!isShorter(to, from.corners + corners, squares_mm2)) return;
                to.corners = from.corners + corners;
                to.squares_mm2 = squares_mm2;
                to.before_place = i;
                to.before_candidate = c;
                to.arcs = std::move(ends);
            };
            if (is_arc) {
                for (Candidate& to : at[nextArc->last]) {
                    ArcChain chain = writtenArc(wanted, *nextArc, from.x_mm, to.x_mm, limits);
                    reach(to, nextArc->last, chain.rank, std::move(chain.ends));
                }
                continue;
            }
            double low = -std::numeric_limits<double>::infinity(), high = -low;
            for (std::size_t j = i + 1; j < count && low <= high; ++j) {
                const double width_mm = wanted[j].z_mm - wanted[i].z_mm;
                for (Candidate& to : at[j]) {
                    const double slope = (to.x_mm - from.x_mm) / width_mm;
                    if (slope >= low && slope <= high) reach(to, j, 1, {});
                }
                if (wanted[j].is_corner) break;
                low = std::max(low, (wanted[j].x_mm - tolerance_mm - from.x_mm) / width_mm);
                high = std::min(high, (wanted[j].x_mm + tolerance_mm - from.x_mm) / width_mm);
            }
        }
    }
    std::size_t place = count - 1, best = at[place].size();
    for (std::size_t c = 0; c < at[place].size(); ++c)
        if (at[place][c].isReached() &&
            (best == at[place].size() || isShorter(at[place][best], at[place][c].corners, at[place][c].squares_mm2)))
            best = c;
    if (best == at[place].size()) return std::nullopt;
    std::vector<WrittenCorner> corners;  // from the last to the first
    for (;;) {
        const Candidate& here = at[place][best];
        if (here.arcs.empty()) corners.push_back({place, here.x_mm, {}});
        for (auto end = here.arcs.rbegin(); end != here.arcs.rend(); ++end)
            corners.push_back({end->place, end->x_mm, end->centre});
        if (place == 0) break;
        place = here.before_place;
        best = here.before_candidate;
    }
    std::reverse(corners.begin(), corners.end());
    return corners;
}

}  // namespace lathelier::deflection
