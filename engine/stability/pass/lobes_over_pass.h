// Lobes over a pass: while the tool moves toward the chuck, the diameter behind it decreases and the stiffness at the
// tool changes. At each station the limit follows from the receptance of the partly turned shaft on its spindle.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/report/document.h"
#include "engine/shaft/shaft.h"
#include "engine/stability/lobes.h"
#include "engine/stability/safe_speed.h"

namespace lathelier::stability {

struct PassParameters {
    std::vector<Interval> pass_z_mm;      ///< at most one: z range of the pass
    std::optional<double> pass_depth_mm;  ///< a, depth of cut on the radius
    int pass_stations = 25;               ///< places of the tool, evenly over the pass, its ends among them

    bool isAsked() const { return !pass_z_mm.empty() || pass_depth_mm.has_value(); }
};

const std::vector<Field<PassParameters>>& fieldsOf(const PassParameters*);

/// Tool and shaft at one place of the pass.
struct PassStation {
    double z_mm = 0;                     ///< of the tool
    double diameter_mm = 0;              ///< machined diameter there
    std::optional<double> minimum_mm{};  ///< limit over all shown speeds; none: no chatter
};

struct PassResult {
    PassParameters parameters;
    std::vector<double> speed_rpm;      ///< of the columns, evenly spaced
    std::vector<PassStation> stations;  ///< of the rows, z ascending
    std::vector<double> limit_mm;       ///< row by row; NaN where no lobe limits
    LobeLimit worst;                    ///< the least limit over the pass; `k` of the lobe
    std::vector<double> worst_z_mm;     ///< z of the least limit; NaN where no lobe limits
    Notes notes;                        ///< of the material

    double at(std::size_t station, std::size_t speed) const { return limit_mm[station * speed_rpm.size() + speed]; }
};

/// `receptance`: lines, shear coefficient and method; its positions are replaced by those of the tool. `lobes`:
/// coefficient (needed), relation, one range of speeds (needed), points; process damping uses the machined diameter.
/// Errors: valueNotUnderstood; those of cutShaft(), shaftReceptance() and findLobes(). Throws Cancelled.
PassResult lobesOverPass(const Shaft& stock, const PassParameters& parameters,
                         const receptance::ReceptanceParameters& receptance, const receptance::ShaftHolding& holding,
                         const LobeParameters& lobes, const Progress& progress = {});

/// Stability of the whole pass at one spindle speed.
struct PassPoint {
    double speed_rpm = 0;              ///< nearest column of the result
    double limit_mm = notANumber;      ///< least limit over the pass; NaN: none
    double z_mm = notANumber;          ///< z of the least limit at that column
    double frequency_hz = notANumber;  ///< of the chatter there; NaN: none
    bool stable = true;                ///< the depth of the pass is below the limit
};
/// The limit is linear between columns. Precondition: the speed lies within those of the result.
PassPoint pointOfPass(const PassResult& result, double speed_rpm);

/// The speed to use for the depth of the pass, among speeds of `range_rpm`. `selected_rpm`: judged; none: the best one.
/// Errors as safeSpeedOn().
SafeSpeed safeOverPass(const PassResult& result, const std::optional<double>& selected_rpm, const Interval& range_rpm);

/// Excess of the depth of cut over the limit, over speed and z; above 0 the pass chatters.
report::ColourMap passMap(const PassResult& result);
/// The least limit over the pass; speed and depth of the pass as a handle.
report::Plot passPlot(const PassResult& result, const SafeSpeed& safe);
report::Table stationsTable(const PassResult& result);
report::Section passSection(const PassResult& result, const SafeSpeed& safe, const Language& language = {});

/// The depth of the pass against the least limit at the selected speed, and the speed to use.
report::Answer passAnswer(const PassResult& result, const SafeSpeed& safe, const Language& language = {});
report::Document passReport(const PassResult& result, const SafeSpeed& safe, const LobeParameters& lobes,
                            const Language& language = {});

/// {z_mm, diameter_mm, minimum_depth_mm: for each station; speed_rpm, depth_mm: rows by station; worst {depth_mm, z_mm,
/// frequency_hz}: for each speed}.
Json passJson(const PassResult& result);

}  // namespace lathelier::stability
