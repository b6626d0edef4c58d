#include "engine/surface/chatter_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/surface/surface_codes.h"

namespace lathelier::surface {
namespace {

using std::numbers::pi;
constexpr double leastNu = 5e-4;    // standard uncertainty due to irregular tracks
constexpr double certainWaves = 2;  // waves across the picture below which m is uncertain…
constexpr double fewWaves = 1.2;    // …unless the cylinder was unrolled and measured m is near a whole number
constexpr double nearWhole = 0.25;
constexpr double wholeNumber = 0.02;  // |ν| below this counts as a whole number of waves
constexpr int mostCandidates = 5;
constexpr double uncheckedScale =
    0.01;  // relative uncertainty of the waves in a revolution: scale, diameter, unrolling…
constexpr double checkedScale = 0.006;  // …where the pitch of the feed marks proves the scale…
constexpr double provedScale = 0.003;   // …to better than this

/// A possible reading of the marks.
struct Candidate {
    int m = 0;
    double nu = 0;
    double frequency_hz = 0;
    double distance = 0;  ///< of m from the measured value, plus a penalty for the less usual sign of ν
};

bool isRegenerative(double nu)
{
    return nu < -wholeNumber && nu > -0.5;
}

/// Uncertainty of a line along a direction, in cycles per pixel.
double lineUncertainty(double significance, const CutFacts& facts, Vector direction)
{
    const double bin = std::hypot(direction.x / facts.columns, direction.y / facts.rows);
    return 0.3 * bin / std::sqrt(std::max(1.0, significance));
}

/// The wave vector of the feed follows from its line, or from the distance of two lines of the lattice.
double combSignificance(const ChatterLattice& lattice, const FeedComb& feed)
{
    const LatticeLine& first = lattice.lines.front();
    double best = feed.significance;
    for (const LatticeLine& line : lattice.lines)
        if (line.multiple == first.multiple && line.order != first.order)
            best = std::max(best, std::min(line.significance, first.significance));
    return best;
}

/// How a slow pattern may be misread. Of synthetic pictures with 0.3 to 1 wave in a revolution: fields of 3 to 9 mm,
/// overviews.
struct SlowPatternLimits {
    double resolved_bins = 2;                                    ///< main lobe of a Hann window
    std::array<double, 6> drawn_bins{0, 0, 0.6, 0.3, 0.1, 0.1};  ///< by q, whole q ν: lines l and l - q in one place
    double shaded_waves = 0.9;                                   ///< in a revolution: shading of an unrolled cylinder
};

/// Error that a slow pattern may have, in waves in a revolution. With q ν whole, its lines l and l - q have one place
/// along the axis; where slow ones are not resolved round the part either, they draw or repel each other.
double slowError(double nu, const CutFacts& facts, Vector feed, Vector y)
{
    constexpr SlowPatternLimits limits;
    const double shaded = facts.unrolled || facts.curved ? limits.shaded_waves : 0;
    const double feeds = std::abs(feed.x) * facts.columns + std::abs(feed.y) * facts.rows;
    const double waves_of_bin = pi * *facts.diameter_px * std::hypot(y.x / facts.columns, y.y / facts.rows);
    for (std::size_t q = 2; q < limits.drawn_bins.size(); ++q) {
        const auto count = static_cast<double>(q);
        const double off_bins = std::abs(count * nu - std::round(count * nu)) * feeds;
        if (off_bins < limits.resolved_bins && count < limits.resolved_bins * waves_of_bin)
            return shaded + limits.drawn_bins[q] * waves_of_bin;
    }
    return shaded;
}

/// Number of waves of the vibration in the picture along the circumference.
double wavesInView(double waves, const CutFacts& facts, Vector y)
{
    const double across = std::abs(y.x) > std::abs(y.y) ? facts.columns / std::abs(y.x) : facts.rows / std::abs(y.y);
    return std::abs(waves) * across / (pi * *facts.diameter_px);
}

void addCandidates(std::vector<Candidate>& candidates, const Reading& reading, double speed_hz, bool certain,
                   double penalty)
{
    const int middle = static_cast<int>(std::lround(*reading.waves));
    const int reach = certain ? 0 : mostCandidates;
    for (int m = std::max(0, middle - reach); m <= middle + reach; ++m)
        if (m + reading.nu > 0)
            candidates.push_back({m, reading.nu, speed_hz * (m + reading.nu), std::abs(m - *reading.waves) + penalty});
}

/// The best first. Readings with the other sign of ν get a penalty of three quarters of a wave, as m of a small field
/// may be wrong by one.
std::vector<Candidate> candidatesOf(const std::vector<Reading>& readings, double speed_hz, bool certain)
{
    constexpr double otherSign = 0.75;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < readings.size(); ++i)
        addCandidates(candidates, readings[i], speed_hz, certain, i == 0 ? 0 : i == 1 ? otherSign : 2 * otherSign);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    std::vector<Candidate> different;  // both signs give equal frequencies if ν is near 0 or ½
    for (const Candidate& candidate : candidates)
        if (std::none_of(different.begin(), different.end(), [&](const Candidate& other) {
                return std::abs(other.frequency_hz - candidate.frequency_hz) < 1e-3 * speed_hz;
            }))
            different.push_back(candidate);
    return different;
}

/// Both signs of ν where the directions are not known, the regenerative one first.
std::vector<Reading> readingsOf(Vector line, Vector feed, const CutFacts& facts)
{
    const auto read = [&](CutDirection cut) {
        return readingOf(line, feed, facts.feed_mm_rev, facts.diameter_mm, facts.diameter_px, cut);
    };
    if (facts.cut != CutDirection::Unknown && facts.feed_direction_deg) return {read(facts.cut)};
    const CutDirection usual = facts.cut == CutDirection::Up ? CutDirection::Up : CutDirection::Down;
    std::vector<Reading> both{read(usual), read(usual == CutDirection::Down ? CutDirection::Up : CutDirection::Down)};
    if (!isRegenerative(both[0].nu) && isRegenerative(both[1].nu)) std::swap(both[0], both[1]);
    // With the opposite sign the helix angle changes sign, which shifts m by 2 ν: compensated here.
    Reading other{-both[0].nu, both[0].waves};
    if (std::abs(std::abs(other.nu) - 0.5) < 1e-9) other = both[0];
    return {both[0], other, both[1]};
}

void describeCrests(ChatterMarks& marks, const CutFacts& facts)
{
    if (!facts.diameter_mm || !marks.m || *marks.m == 0) return;
    marks.circumferential_pitch_mm = pi * *facts.diameter_mm / *marks.m;
    if (facts.feed_mm_rev)
        marks.inclination_deg = inclination_deg(marks.nu, *marks.m, *facts.diameter_mm, *facts.feed_mm_rev);
}

/// Distance of the nearest different frequency in `all`.
std::optional<double> nearestOther(const std::vector<Candidate>& all, const Candidate& best)
{
    std::optional<double> nearest;
    for (const Candidate& candidate : all) {
        const double away = std::abs(candidate.frequency_hz - best.frequency_hz);
        if (away > 0 && (!nearest || away < *nearest)) nearest = away;
    }
    return nearest;
}

void chooseExpected(std::vector<Candidate>& candidates, double expect_hz, const std::string& path, Notes& notes)
{
    const auto nearest = std::min_element(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.frequency_hz - expect_hz) < std::abs(b.frequency_hz - expect_hz);
    });
    if (candidates.size() < 2) return;
    std::rotate(candidates.begin(), nearest, nearest + 1);
    notes.push_back({notes::chosenByExpectation,
                     {{"path", path}, {"frequency_hz", candidates.front().frequency_hz}, {"expected_hz", expect_hz}}});
}

/// m and its uncertainty. `comb`: of the feed, toward it; `marks` with ν.
void measureWaves(ChatterMarks& marks, const ChatterLattice& lattice, const FeedComb& feed, Vector comb, double waves,
                  const CutFacts& facts)
{
    const Vector z = axisDirection(comb, facts.feed_mm_rev, facts.diameter_mm, facts.cut);
    const Vector y = turned(z, 90);
    marks.waves_measured = waves;
    marks.waves_in_view = wavesInView(waves + marks.nu, facts, y);
    const bool is_proved = facts.scale_error && std::abs(*facts.scale_error) < provedScale;
    const double scale = is_proved ? checkedScale : uncheckedScale;
    const double orders = dot(lattice.fundamental, z) / dot(comb, z);  // the axis is known from the feed marks
    const double u_line = std::hypot(lineUncertainty(lattice.significance, facts, y),
                                     orders * lineUncertainty(combSignificance(lattice, feed), facts, y));
    const double u_m = pi * *facts.diameter_px * u_line + scale * waves;
    marks.waves_uncertainty = u_m;
    marks.slowest_waves = waves + marks.nu - 2 * u_m - slowError(marks.nu, facts, comb, y);
    const double off = std::abs(waves - std::round(waves));
    const bool enough =
        *marks.waves_in_view >= certainWaves || (facts.unrolled && *marks.waves_in_view >= fewWaves && off < nearWhole);
    marks.m_certain = !facts.curved && facts.scale_checked && enough && off + 2 * u_m < 0.5;
    marks.m = static_cast<int>(std::lround(waves));
}

}  // namespace

Vector towardFeed(Vector comb, const std::optional<double>& feed_direction_deg)
{
    const Vector wanted = turned({1, 0}, feed_direction_deg.value_or(0));
    const double along = dot(comb, wanted);
    if (!feed_direction_deg && std::abs(along) < 1e-3 * length(comb)) return comb.y < 0 ? -1.0 * comb : comb;
    return along < 0 ? -1.0 * comb : comb;
}

ChatterMarks readChatter(const ChatterLattice& lattice, const FeedComb& feed, const CutFacts& facts,
                         const std::string& path, Notes& notes)
{
    const Vector comb = towardFeed(feed.frequency, facts.feed_direction_deg);
    const std::vector<Reading> readings = readingsOf(lattice.fundamental, comb, facts);
    const Vector z = axisDirection(comb, facts.feed_mm_rev, facts.diameter_mm, facts.cut);
    const double u_nu = std::max(leastNu, lineUncertainty(lattice.significance, facts, z) / dot(comb, z));

    ChatterMarks marks;
    marks.nu = readings.front().nu;
    marks.amplitude = lattice.amplitude;
    marks.relative_to_feed = lattice.amplitude / feed.amplitude;
    marks.significance = lattice.significance;
    marks.lines = static_cast<int>(lattice.lines.size());
    const bool sign_known = readings.size() == 1;
    if (readings.front().waves) measureWaves(marks, lattice, feed, comb, *readings.front().waves, facts);
    if (marks.waves_measured && !marks.m_certain && !facts.curved)  // curvature has its own note
        notes.push_back({notes::wavesUncertain, {{"path", path}, {"waves", *marks.waves_in_view}}});
    if (marks.waves_measured && facts.speed_rpm) {
        const double speed_hz = *facts.speed_rpm / 60;
        const std::vector<Candidate> all = candidatesOf(readings, speed_hz, marks.m_certain);
        std::vector<Candidate> candidates(all.begin(),
                                          all.begin() + std::min<std::ptrdiff_t>(mostCandidates, std::ssize(all)));
        if (facts.expect_hz && !candidates.empty()) chooseExpected(candidates, *facts.expect_hz, path, notes);
        for (const Candidate& candidate : candidates) marks.candidates_hz.push_back(candidate.frequency_hz);
        if (!candidates.empty()) {
            const Candidate& best = candidates.front();
            marks.m = best.m;
            marks.nu = best.nu;
            marks.frequency_hz = best.frequency_hz;
            marks.frequency_uncertainty_hz = std::hypot(speed_hz * u_nu, best.frequency_hz * facts.speed_uncertainty);
            marks.harmonic_of_hz = {best.frequency_hz / 2, best.frequency_hz / 3};
            marks.nearest_other_hz = nearestOther(all, best).value_or(speed_hz);
            if (!sign_known && std::abs(best.nu) > wholeNumber)
                notes.push_back(
                    {notes::directionsUnknown,
                     {{"path", path}, {"first_hz", best.frequency_hz}, {"second_hz", speed_hz * (best.m - best.nu)}}});
        }
    }
    marks.phase_deg = phase_deg(marks.nu);
    if (facts.feed_mm_rev && std::abs(marks.nu) > 1e-6) marks.axial_period_mm = *facts.feed_mm_rev / std::abs(marks.nu);
    describeCrests(marks, facts);
    if (std::abs(marks.nu) <= wholeNumber)
        marks.kind = ChatterKind::Forced;
    else if (sign_known)
        marks.kind = isRegenerative(marks.nu) ? ChatterKind::Regenerative : ChatterKind::Forced;
    return marks;
}

}  // namespace lathelier::surface
