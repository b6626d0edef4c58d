#include "engine/receptance/eirc/identify_spindle.h"

#include <algorithm>
#include <cmath>

#include "engine/receptance/eirc/fit_spindle.h"
#include "engine/receptance/eirc/smooth_spindle.h"
#include "engine/receptance/eirc/spindle_lines.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/receptance_fields.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t fewestFrfs = 3;  // number of unknowns per line
constexpr double illConditioned = 1e4;

/// 100·rms(|G_fit - G|/|G|); NaN without any response.
double misfitPercent(const std::vector<SpindleLine>& lines, const std::vector<ScaledSpindle>& spindle)
{
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (const LineResponse& one : lines[i].responses) {
            if (!(one.weight > 0)) continue;
            sum += std::norm((responseOn(lines[i], one, spindle[i]) - one.measured) / one.measured);
            ++count;
        }
    return 100 * std::sqrt(sum / count);
}

SpindleTable identifiedTable(const std::vector<double>& frequency_hz, const std::vector<ScaledSpindle>& spindle)
{
    SpindleTable table;
    table.frequency_hz = frequency_hz;
    for (const ScaledSpindle& one : spindle) {
        const ReceptanceMatrix matrix = matrixOf(one);
        table.H_mm_N.push_back(matrix(0, 0));
        table.L_mm_Nmm.push_back(matrix(0, 1));
        table.P_rad_Nmm.push_back(matrix(1, 1));
    }
    return table;
}

void noteDoubts(const std::vector<LineFit>& fits, std::int64_t active, Notes& notes)
{
    const auto all = static_cast<std::int64_t>(fits.size());
    const std::int64_t ill =
        std::count_if(fits.begin(), fits.end(), [](const LineFit& fit) { return !(fit.condition <= illConditioned); });
    const std::int64_t open =
        std::count_if(fits.begin(), fits.end(), [](const LineFit& fit) { return !fit.converged; });
    if (ill > 0)
        notes.push_back({notes::spindleIllConditioned, {{"lines", ill}, {"all", all}, {"limit", illConditioned}}});
    if (open > 0) notes.push_back({notes::spindleNotConverged, {{"lines", open}, {"all", all}}});
    if (active > 0) notes.push_back({notes::spindleNotPassive, {{"lines", active}, {"all", all}}});
}

/// Where the measurements contradict each other by more than their noise.
void noteResidual(const SpindleIdentification& found, Notes& notes)
{
    const bool is_explained = found.chi2_per_dof && *found.chi2_per_dof <= explainedByNoise;
    if (!(found.residual_rms_percent > largestResidual_percent) || is_explained) return;
    notes.push_back({notes::spindleNotExplained,
                     {{"percent", found.residual_rms_percent},
                      {"limit", largestResidual_percent},
                      {"expected", found.expected_rms_percent ? Value(*found.expected_rms_percent) : Value()}}});
}

/// A part of the measurements: the rods used, or the one held out.
struct Setting {
    SpindleMeasurements measurements;  ///< all rods, the responses of this part
    SpindleNoise noise;
    std::vector<std::size_t> frfs;  ///< index of each response in the whole
    beam::ShearModel shear = {};
    bool smooth = false;
};

Setting settingOf(const SpindleMeasurements& all, const SpindleNoise& noise, const IdentificationParameters& parameters,
                  bool is_held_out)
{
    Setting part;
    part.measurements.rods = all.rods;
    part.measurements.averages = all.averages;
    part.noise.source = noise.source;
    part.shear = parameters.shear;
    part.smooth = parameters.smooth;
    for (std::size_t k = 0; k < all.frfs.size(); ++k) {
        if ((static_cast<int>(all.frfs[k].rod) + 1 == parameters.hold_out) != is_held_out) continue;
        part.measurements.frfs.push_back(all.frfs[k]);
        part.noise.sigma_mm_N.push_back(noise.sigma_mm_N[k]);
        part.frfs.push_back(k);
    }
    return part;
}

Error tooFew(const SpindleMeasurements& measurements, std::size_t frfs)
{
    std::size_t points = 0;
    for (const MeasuredRod& rod : measurements.rods) points += rod.distance_from_chuck_mm.size();
    return {errors::tooFewMeasuredPoints,
            {{"points", static_cast<std::int64_t>(points)}, {"frfs", static_cast<std::int64_t>(frfs)}}};
}

struct Found {
    SpindleLines lines;
    std::vector<LineFit> fits;
    std::vector<ScaledSpindle> spindle;
};

Found solveAll(const Setting& setting, UsedValues& used, Notes& notes, const Progress& progress)
{
    Found found;
    found.lines = spindleLines(setting.measurements, setting.noise, setting.shear, used, notes, progress.part(0, 0.1));
    progress.report(0.1);
    found.fits = fitSpindle(found.lines, progress.part(0.1, 0.8));
    if (setting.smooth)
        found.spindle = smoothed(found.lines.frequency_hz, found.fits, progress.part(0.8, 1));
    else
        for (const LineFit& fit : found.fits) found.spindle.push_back(fit.spindle);
    return found;
}

double heldOutPercent(const Setting& held, const std::vector<ScaledSpindle>& spindle, const Progress& progress)
{
    UsedValues used;
    Notes notes;
    return misfitPercent(spindleLines(held.measurements, held.noise, held.shear, used, notes, progress).lines, spindle);
}

/// Where the mistake is, and what its remedy does.
Values valuesOf(const SpindleRemedy& remedy, const SpindleMeasurements& measurements, double before_percent,
                double after_percent)
{
    const MeasuredRod& rod = measurements.rods[remedy.rod];
    Values values{{"rod", static_cast<std::int64_t>(remedy.rod) + 1},
                  {"before_percent", before_percent},
                  {"after_percent", after_percent}};
    const auto add = [&values](const char* name, Value value) { values.emplace_back(name, std::move(value)); };
    switch (remedy.kind) {
        case RemedyKind::Sign:
        case RemedyKind::LeaveOut:
            add("respond", rod.nodeOf(remedy.point_a));
            add("excite", rod.nodeOf(remedy.point_b));
            break;
        case RemedyKind::Swap:
            add("first", rod.nodeOf(remedy.point_a));
            add("second", rod.nodeOf(remedy.point_b));
            break;
        case RemedyKind::Distance: add("node", rod.nodeOf(remedy.point_a)); [[fallthrough]];
        case RemedyKind::Length:
            add("stated_mm", remedy.stated_mm);
            add("fitted_mm", remedy.fitted_mm);
            break;
    }
    return values;
}

/// The mistake, if there is one, with the residual that its remedy leaves.
std::optional<TriedRemedy> triedRemedy(const Setting& setting, const FitQuality& quality, double before_percent,
                                       const Progress& progress)
{
    const auto remedy = findRemedy(setting.measurements, setting.noise, setting.shear, quality, progress.part(0, 0.6));
    if (!remedy) return std::nullopt;
    Setting mended = setting;
    mended.measurements = remedied(setting.measurements, *remedy);
    if (remedy->kind == RemedyKind::LeaveOut)
        mended.noise.sigma_mm_N[remedy->frf].assign(mended.noise.sigma_mm_N[remedy->frf].size(), HUGE_VAL);
    UsedValues used;
    Notes notes;
    const Found found = solveAll(mended, used, notes, progress.part(0.6, 1));
    TriedRemedy tried{*remedy, misfitPercent(found.lines.lines, found.spindle), {}};
    tried.remedy.frf = setting.frfs[remedy->frf];
    tried.values = valuesOf(*remedy, setting.measurements, before_percent, tried.rms_percent);
    return tried;
}

const NoteCode& codeOf(RemedyKind kind)
{
    switch (kind) {
        case RemedyKind::Sign: return notes::spindleSignTurned;
        case RemedyKind::Swap: return notes::spindlePointsSwapped;
        case RemedyKind::Distance: return notes::spindlePointMisplaced;
        case RemedyKind::Length: return notes::spindleRodLength;
        case RemedyKind::LeaveOut: break;
    }
    return notes::spindleResponseStandsOut;
}

}  // namespace

const std::vector<Field<IdentificationParameters>>& fieldsOf(const IdentificationParameters*)
{
    using P = IdentificationParameters;
    static const std::vector<Field<P>> all{
        field("smooth", &P::smooth,
              Label{LT_TEXT("Engine", "Smooth"),
                    LT_TEXT("Engine", "Along frequency, by what each line knows and does not know.")}),
        field("hold_out", &P::hold_out, Range{0, 100},
              Label{LT_TEXT("Engine", "Hold out rod"),
                    LT_TEXT("Engine", "This rod is not used but predicted; 0: all are used.")}),
        shearField(&P::shear),
    };
    return all;
}

SpindleIdentification identifySpindle(const SpindleMeasurements& measurements,
                                      const IdentificationParameters& parameters, const Progress& progress)
{
    SpindleIdentification result;
    result.parameters = parameters;
    const auto rods = static_cast<std::int64_t>(measurements.rods.size());
    if (parameters.hold_out < 0 || parameters.hold_out > rods)
        throw Error(errors::holdOutUnknown, {{"rod", std::int64_t{parameters.hold_out}}, {"rods", rods}});
    progress.report(0);
    checkMeasurements(measurements);
    const SpindleNoise noise = spindleNoise(measurements);
    const Setting used = settingOf(measurements, noise, parameters, false);
    const Setting held = settingOf(measurements, noise, parameters, true);
    result.frfs = used.frfs.size();
    if (result.frfs < fewestFrfs) throw tooFew(measurements, result.frfs);
    const Found found = solveAll(used, result.used, result.notes, progress.part(0, 0.6));
    for (const LineFit& fit : found.fits) result.condition.push_back(fit.condition);
    result.frequency_hz = found.lines.frequency_hz;
    result.residual_rms_percent = misfitPercent(found.lines.lines, found.spindle);
    if (!held.frfs.empty()) result.hold_out_rms_percent = heldOutPercent(held, found.spindle, progress.part(0.6, 0.65));
    const FitQuality quality = qualityOf(found.lines.lines, found.fits);
    const bool is_noise_known = noise.source != NoiseSource::Unknown;
    result.noise_from = noise.source;
    result.chi2_per_dof_of_frfs.resize(measurements.frfs.size());
    if (is_noise_known) {
        result.chi2_per_dof = quality.chi2_per_dof;
        result.expected_rms_percent = quality.expected_rms_percent;
        for (std::size_t k = 0; k < used.frfs.size(); ++k)
            result.chi2_per_dof_of_frfs[used.frfs[k]] = quality.chi2_per_dof_of_responses[k];
    }
    result.remedy = triedRemedy(used, quality, result.residual_rms_percent, progress.part(0.65, 1));
    noteDoubts(found.fits, activeLines(found.fits, found.spindle, is_noise_known), result.notes);
    noteResidual(result, result.notes);
    if (result.remedy) result.notes.push_back({codeOf(result.remedy->remedy.kind), result.remedy->values});
    result.spindle = {identifiedTable(found.lines.frequency_hz, found.spindle)};
    progress.report(1);
    return result;
}

}  // namespace lathelier::receptance
