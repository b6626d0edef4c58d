#include "engine/receptance/eirc/spindle_remedy.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "engine/core/parallel.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t linesOfAll = 6;    // on which all remedies are tried
constexpr std::size_t linesOfBest = 32;  // on which the best are
constexpr std::size_t mostFinalists = 5;
constexpr std::size_t mostOutstanding = 12;  // responses whose remedies are tried
constexpr double levelOfOthers = 0.2;        // largest share of the excess of chi² over 1 that may be left
constexpr double aloneBy = 1.5;              // every other remedy leaves at least so much more
constexpr double smallestShift_mm = 2;       // less is the care of a rule, not a mistake
constexpr double shifts_mm[] = {-20, -8, -3, 3, 8, 20};
constexpr int narrowings = 10;

/// A selection of lines.
struct Sample {
    SpindleMeasurements measurements;
    SpindleNoise noise;
};

Sample sampleOf(const SpindleMeasurements& measurements, const SpindleNoise& noise, std::size_t most_lines)
{
    std::vector<std::size_t> above;
    const std::vector<double>& frequency_hz = measurements.frfs.front().frf.frequency_hz;
    for (std::size_t i = 0; i < frequency_hz.size(); ++i)
        if (frequency_hz[i] > 0) above.push_back(i);
    const std::size_t count = std::min(most_lines, above.size());
    Sample sample;
    sample.measurements.rods = measurements.rods;
    sample.noise.source = noise.source;
    for (std::size_t k = 0; k < measurements.frfs.size(); ++k) {
        const RodFrf& one = measurements.frfs[k];
        RodFrf taken{one.rod, one.point_a, one.point_b, {one.frf.name, one.frf.quantity, {}, {}, {}, {}}};
        std::vector<double>& sigma_mm_N = sample.noise.sigma_mm_N.emplace_back();
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t line = above[(2 * i + 1) * above.size() / (2 * count)];
            taken.frf.frequency_hz.push_back(frequency_hz[line]);
            taken.frf.value.push_back(one.frf.value[line]);
            sigma_mm_N.push_back(noise.sigma_mm_N[k][line]);
        }
        sample.measurements.frfs.push_back(std::move(taken));
    }
    return sample;
}

/// Tries remedies on a sample.
class Trial {
public:
    Trial(const SpindleMeasurements& measurements, const SpindleNoise& noise, beam::ShearModel shear,
          std::size_t most_lines)
        : sample_(sampleOf(measurements, noise, most_lines)),
          shear_(shear),
          asStated_(fitApart(linesOf(sample_.measurements, sample_.noise)))
    {
    }

    double asStated() const { return chi2PerDof(asStated_); }

    /// chi² per degree of freedom with the remedy.
    double with(const SpindleRemedy& remedy) const
    {
        SpindleNoise noise = sample_.noise;
        if (remedy.kind == RemedyKind::LeaveOut)
            std::fill(noise.sigma_mm_N[remedy.frf].begin(), noise.sigma_mm_N[remedy.frf].end(), HUGE_VAL);
        return chi2PerDof(fitApart(linesOf(remedied(sample_.measurements, remedy), noise), asStated_));
    }

private:
    SpindleLines linesOf(const SpindleMeasurements& measurements, const SpindleNoise& noise) const
    {
        UsedValues used;
        Notes notes;
        return spindleLines(measurements, noise, shear_, used, notes, {});
    }

    Sample sample_;
    beam::ShearModel shear_;
    std::vector<LineFit> asStated_;
};

struct Tried {
    SpindleRemedy remedy;
    double chi2 = HUGE_VAL;
};

bool isMove(RemedyKind kind)
{
    return kind == RemedyKind::Distance || kind == RemedyKind::Length;
}

bool isSame(const SpindleRemedy& a, const SpindleRemedy& b)
{
    return a.kind == b.kind && a.frf == b.frf && a.rod == b.rod && a.point_a == b.point_a && a.point_b == b.point_b;
}

/// Smallest and largest value that keeps every point on its rod.
Interval rangeOnRod(const SpindleMeasurements& measurements, const SpindleRemedy& remedy)
{
    const MeasuredRod& rod = measurements.rods[remedy.rod];
    if (remedy.kind == RemedyKind::Distance) return {0, rod.shaft.length_mm()};
    return {*std::max_element(rod.distance_from_chuck_mm.begin(), rod.distance_from_chuck_mm.end()), HUGE_VAL};
}

std::vector<std::size_t> outstanding(const FitQuality& quality)
{
    const auto chi2 = [&](std::size_t k) { return quality.chi2_per_dof_of_responses[k].value_or(HUGE_VAL); };
    std::vector<std::size_t> order(quality.chi2_per_dof_of_responses.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return chi2(a) > chi2(b); });
    if (order.size() > mostOutstanding) order.resize(mostOutstanding);
    return order;
}

void addMoves(const SpindleMeasurements& measurements, SpindleRemedy remedy, double stated_mm,
              std::vector<Tried>& tried)
{
    remedy.stated_mm = stated_mm;
    const Interval range = rangeOnRod(measurements, remedy);
    std::vector<double> values;
    for (const double shift_mm : shifts_mm) values.push_back(std::clamp(stated_mm + shift_mm, range.from, range.to));
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const double value_mm : values) {
        if (value_mm == stated_mm) continue;
        remedy.fitted_mm = value_mm;
        tried.push_back({remedy});
    }
}

/// Remedies of the responses that stand out, of their points and rods.
std::vector<Tried> remediesOf(const SpindleMeasurements& measurements, const std::vector<std::size_t>& responses)
{
    std::vector<Tried> tried;
    std::vector<std::vector<bool>> points;
    for (const MeasuredRod& rod : measurements.rods) points.emplace_back(rod.distance_from_chuck_mm.size(), false);
    for (const std::size_t frf : responses) {
        const RodFrf& one = measurements.frfs[frf];
        points[one.rod][one.point_a] = points[one.rod][one.point_b] = true;
        tried.push_back({{RemedyKind::Sign, frf, one.rod, one.point_a, one.point_b}});
        tried.push_back({{RemedyKind::LeaveOut, frf, one.rod, one.point_a, one.point_b}});
    }
    for (std::size_t rod = 0; rod < points.size(); ++rod) {
        const MeasuredRod& of = measurements.rods[rod];
        for (std::size_t a = 0; a < points[rod].size(); ++a) {
            if (!points[rod][a]) continue;
            for (std::size_t b = 0; b < points[rod].size(); ++b)
                if (points[rod][b] ? b > a : b != a) tried.push_back({{RemedyKind::Swap, 0, rod, a, b}});
            addMoves(measurements, {RemedyKind::Distance, 0, rod, a, 0}, of.distance_from_chuck_mm[a], tried);
        }
        if (std::find(points[rod].begin(), points[rod].end(), true) != points[rod].end())
            addMoves(measurements, {RemedyKind::Length, 0, rod, 0, 0}, of.shaft.length_mm(), tried);
    }
    return tried;
}

/// Golden section between the neighbours of a value of the grid.
Tried narrowed(const Trial& trial, const SpindleMeasurements& measurements, Tried best, const Progress& progress)
{
    const Interval range = rangeOnRod(measurements, best.remedy);
    const double shift_mm = best.remedy.fitted_mm - best.remedy.stated_mm;
    double low = std::max(range.from, best.remedy.stated_mm + std::min(shift_mm / 2, shift_mm * 2));
    double high = std::min(range.to, best.remedy.stated_mm + std::max(shift_mm / 2, shift_mm * 2));
    const double golden = (std::sqrt(5.0) - 1) / 2;
    const auto at = [&](double value_mm) {
        progress.check();
        Tried one = best;
        one.remedy.fitted_mm = value_mm;
        one.chi2 = trial.with(one.remedy);
        if (one.chi2 < best.chi2) best = one;
        return one.chi2;
    };
    best.chi2 = trial.with(best.remedy);
    double left = high - golden * (high - low), right = low + golden * (high - low);
    double of_left = at(left), of_right = at(right);
    for (int i = 0; i < narrowings; ++i) {
        if (of_left < of_right) {
            high = right;
            right = left;
            of_right = of_left;
            of_left = at(left = high - golden * (high - low));
        } else {
            low = left;
            left = right;
            of_left = of_right;
            of_right = at(right = low + golden * (high - low));
        }
    }
    return best;
}

bool isBetter(const Tried& a, const Tried& b)
{
    return a.chi2 < b.chi2;
}

/// The best remedies, each once, tried on more lines and their values fitted; best first.
std::vector<Tried> finalists(std::vector<Tried> tried, const Trial& trial, const SpindleMeasurements& measurements,
                             const Progress& progress)
{
    std::stable_sort(tried.begin(), tried.end(), isBetter);
    std::vector<Tried> best;
    for (const Tried& one : tried) {
        if (best.size() == mostFinalists) break;
        const auto same = [&one](const Tried& other) { return isSame(one.remedy, other.remedy); };
        if (std::none_of(best.begin(), best.end(), same)) best.push_back(one);
    }
    parallelFor(best.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (isMove(best[i].remedy.kind))
                best[i] = narrowed(trial, measurements, best[i], progress);
            else
                best[i].chi2 = trial.with(best[i].remedy);
    });
    std::stable_sort(best.begin(), best.end(), isBetter);
    return best;
}

/// The first one, if it and no other does away with the excess.
std::optional<SpindleRemedy> clearly(const std::vector<Tried>& best, double stated)
{
    if (best.empty() || !(best.front().chi2 - 1 <= levelOfOthers * (stated - 1))) return std::nullopt;
    if (best.size() > 1 && !(best[1].chi2 > aloneBy * best.front().chi2)) return std::nullopt;
    const SpindleRemedy& remedy = best.front().remedy;
    const bool is_far = std::abs(remedy.fitted_mm - remedy.stated_mm) >= smallestShift_mm;
    return isMove(remedy.kind) && !is_far ? std::nullopt : std::optional(remedy);
}

}  // namespace

SpindleMeasurements remedied(const SpindleMeasurements& measurements, const SpindleRemedy& remedy)
{
    SpindleMeasurements result = measurements;
    std::vector<double>& distances_mm = result.rods[remedy.rod].distance_from_chuck_mm;
    switch (remedy.kind) {
        case RemedyKind::Sign:
            for (Complex& value : result.frfs[remedy.frf].frf.value) value = -value;
            break;
        case RemedyKind::Swap: std::swap(distances_mm[remedy.point_a], distances_mm[remedy.point_b]); break;
        case RemedyKind::Distance: distances_mm[remedy.point_a] = remedy.fitted_mm; break;
        case RemedyKind::Length:
            result.rods[remedy.rod].shaft.segments.back().length_mm += remedy.fitted_mm - remedy.stated_mm;
            break;
        case RemedyKind::LeaveOut: break;
    }
    return result;
}

std::optional<SpindleRemedy> findRemedy(const SpindleMeasurements& measurements, const SpindleNoise& noise,
                                        beam::ShearModel shear, const FitQuality& quality, const Progress& progress)
{
    if (noise.source == NoiseSource::Unknown || !(quality.chi2_per_dof.value_or(0) > explainedByNoise))
        return std::nullopt;
    const Trial few(measurements, noise, shear, linesOfAll), more(measurements, noise, shear, linesOfBest);
    std::vector<Tried> mending = remediesOf(measurements, outstanding(quality));
    parallelFor(mending.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) mending[i].chi2 = few.with(mending[i].remedy);
    });
    progress.report(0.6);
    std::vector<Tried> leaving;
    const auto is_leaving = [](const Tried& one) { return one.remedy.kind == RemedyKind::LeaveOut; };
    std::copy_if(mending.begin(), mending.end(), std::back_inserter(leaving), is_leaving);
    std::erase_if(mending, is_leaving);
    const double stated = more.asStated();
    const std::vector<Tried> best = finalists(std::move(mending), more, measurements, progress);
    if (const auto found = clearly(best, stated)) return found;
    return clearly(finalists(std::move(leaving), more, measurements, progress), stated);
}

const char* key(RemedyKind kind)
{
    switch (kind) {
        case RemedyKind::Sign: return "sign";
        case RemedyKind::Swap: return "swap";
        case RemedyKind::Distance: return "distance";
        case RemedyKind::Length: return "length";
        case RemedyKind::LeaveOut: break;
    }
    return "leave_out";
}

}  // namespace lathelier::receptance
