#include "engine/registration/verdict/revolution_grids.h"

#include <cmath>

#include "engine/core/units.h"
#include "engine/registration/scanner_spot.h"

namespace lathelier::registration {
namespace {

/// What a stretch and a face of the meridian need (registration/README.md, "Thresholds").
struct StretchThresholds {
    double face_reach_mm = 2;         ///< largest distance of a copy's face from the reference's
    std::size_t least_bore_bins = 3;  ///< of a run of the bore
    double least_known_bins = 2;      ///< of a stretch, with a radius
};
constexpr StretchThresholds stretchThresholds{};

}  // namespace

Stretches::Stretches(const TurnedPart& part, const MeridianLine& line, bool with_faces) : part_(part), line_(line)
{
    const RadiusProfile& profile = part.fit.profile;
    for (const SmoothRun& run : smoothRuns(part)) add(run, profile, false);
    if (part.fit.bore.size() == profile.size()) addBore(part.fit.bore);
    outside_ = tableOf(false);
    if (part.fit.bore.size() == profile.size()) bore_ = tableOf(true);
    if (with_faces) addFaces();
}

void Stretches::addFaces()
{
    const std::vector<MeasuredFace>& faces = line_.faces();
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const MeasuredFace& face = faces[f];
        if (stretches_.size() >= noStretch || face.outer_mm - face.inner_mm < smearedEdge_mm) continue;
        double reach = stretchThresholds.face_reach_mm;
        if (f > 0) reach = std::min(reach, (face.z_mm - faces[f - 1].z_mm) / 2);
        if (f + 1 < faces.size()) reach = std::min(reach, (faces[f + 1].z_mm - face.z_mm) / 2);
        const double middle = (face.inner_mm + face.outer_mm) / 2;
        faces_.push_back({&face, static_cast<std::uint8_t>(stretches_.size()), reach, face.inner_mm - smearedEdge_mm,
                          face.outer_mm + smearedEdge_mm});
        grids_.push_back({face.inner_mm, face.outer_mm, middle, true});
        const double z = std::clamp(face.z_mm - line_.zFirst_mm(), 0.0, line_.zLast_mm() - line_.zFirst_mm());
        stretches_.push_back(
            {z, z, false, middle, 0, face.sigma_mm, face.ring_mm, face.facing, face.inner_mm, face.outer_mm});
    }
}

void Stretches::add(const SmoothRun& run, const RadiusProfile& profile, bool is_bore)
{
    const double start = run.start_mm + smearedEdge_mm;
    const double end = run.end_mm - smearedEdge_mm;
    if (end < start + smearedEdge_mm || stretches_.size() >= noStretch) return;
    Grid grid{start, end};
    double variance = 0;
    double known = 0;
    for (std::size_t i = run.first; i < run.last; ++i) {
        if (std::isnan(profile.radius_mm[i])) continue;
        grid.radius_mm = std::max(grid.radius_mm, profile.radius_mm[i]);
        variance += profile.sigma_mm[i] * profile.sigma_mm[i];
        known += 1;
    }
    if (known < stretchThresholds.least_known_bins) return;
    const double rise = profile.radius_mm[run.last - 1] - profile.radius_mm[run.first];
    grids_.push_back(grid);
    stretches_.push_back({start - line_.zFirst_mm(), end - line_.zFirst_mm(), is_bore,
                          (profile.radius_mm[run.last - 1] + profile.radius_mm[run.first]) / 2,
                          rise / (static_cast<double>(run.last - 1 - run.first) * profile.step_mm),
                          std::sqrt(variance / known), profile.step_mm});
}

void Stretches::addBore(const RadiusProfile& bore)
{
    std::size_t from = 0;
    const auto finish = [&](std::size_t to) {
        if (to >= from + stretchThresholds.least_bore_bins)
            add({from, to, bore.middle_mm(from) - bore.step_mm / 2, bore.middle_mm(to) - bore.step_mm / 2}, bore, true);
    };
    for (std::size_t i = 0; i < bore.size(); ++i) {
        const bool known = !std::isnan(bore.radius_mm[i]);
        const bool edge = known && i > from && std::abs(bore.radius_mm[i] - bore.radius_mm[i - 1]) > bore.step_mm;
        if (known && !edge) continue;
        finish(i);
        from = known ? i : i + 1;
    }
    finish(bore.size());
}

std::vector<std::uint8_t> Stretches::tableOf(bool is_bore) const
{
    const RadiusProfile& profile = part_.fit.profile;
    std::vector<std::uint8_t> table(profile.size() * tablePlacesPerBin, noStretch);
    const double step = profile.step_mm / static_cast<double>(tablePlacesPerBin);
    for (std::size_t s = 0; s < grids_.size(); ++s) {
        if (stretches_[s].is_bore != is_bore || stretches_[s].isFace()) continue;
        const auto at = [&](double z) {
            return static_cast<std::size_t>(
                std::clamp((z - profile.z_start_mm) / step, 0.0, static_cast<double>(table.size() - 1)));
        };
        for (std::size_t k = at(grids_[s].start_mm); k <= at(grids_[s].end_mm); ++k)
            table[k] = static_cast<std::uint8_t>(s);
    }
    return table;
}

std::size_t layOut(std::vector<Grid>& grids, double size_mm)
{
    std::size_t count = 0;
    const auto parts = [&](double length) {
        return static_cast<std::size_t>(std::max(1.0, std::round(length / size_mm)));
    };
    for (Grid& grid : grids) {
        grid.rows = parts(grid.end_mm - grid.start_mm);
        grid.columns = parts(turn_rad * grid.radius_mm);
        grid.first = count;
        count += grid.cellCount();
    }
    return count;
}

}  // namespace lathelier::registration
