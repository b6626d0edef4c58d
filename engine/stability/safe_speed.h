// The speed to cut at, judged by the depth of cut: is the selected speed stable there, how deep may it go, and which
// speed of the range bears the most. One rule for lobes, passes and speeds; exact relation of speed and chatter
// frequency only, for the published one has no depths (lobes.h).
//
// A speed of the range is judged by the least limit within ±2 % of it: the narrow tip of a pocket is no speed to
// recommend, for the natural frequencies are known no better.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/json.h"
#include "engine/core/quantities.h"
#include "engine/report/answer.h"
#include "engine/report/chart.h"
#include "engine/stability/lobes.h"
#include "engine/stability/nearby.h"

namespace lathelier::stability {

/// What is asked of the limit.
struct SafeSpeedQuestion {
    double selected_rpm = 0;  ///< selected speed
    double depth = 0;         ///< mm, or multiples of the least limit as the limit has them
    Interval range_rpm;       ///< speeds that may be recommended
};

/// A speed and how deep it may cut.
struct DepthAtSpeed {
    double speed_rpm = 0;
    std::optional<double> limit;   ///< there; none: no lobe limits
    std::optional<double> margin;  ///< limit less the depth asked for; none: no lobe limits
    bool is_stable = true;         ///< the depth asked for is below the limit
};

struct SafeSpeed {
    SafeSpeedQuestion question;
    DepthAtSpeed selected;
    DepthAtSpeed best;                ///< of the range; with equal limits the nearest to the selected speed
    std::vector<DepthAtSpeed> peaks;  ///< pockets of the range, the deepest first, at most 5

    /// The speed to recommend; none: no speed of the range is stable at the depth.
    std::optional<double> recommendedRpm() const;
};

/// The range of speeds about one that is selected, where none was asked for: from half of it to one and a half.
Interval usualRange(double selected_rpm);

/// The range with the margins that its ends are judged by.
Interval withMargins(const Interval& range_rpm);

/// Judged on a limit that is known: of lobes, or of a pass at its worst place. Beyond the speeds of the limit nothing
/// is known; the range is cut there. Error valueNotUnderstood where nothing of it is left, or the selected speed lies
/// outside.
SafeSpeed safeSpeedOn(const LobeLimit& limit, const SafeSpeedQuestion& question);

/// The same with the limit of a response, by the exact relation. `lobes`: coefficient, process damping, direction
/// factor. Errors as findLobes(). Throws Cancelled.
SafeSpeed safeSpeed(const Frf& frf, const LobeParameters& lobes, const SafeSpeedQuestion& question,
                    const Progress& progress = {});

/// {stable_at_selected, largest_depth_at_selected_mm, best {speed_rpm, depth_limit_mm, margin_mm}, …}; `is_relative`:
/// the keys without _mm.
Json toJson(const SafeSpeed& safe, bool is_relative);

/// "At 0.400 mm use 3640 1/min: stable up to 0.500 mm", or that no speed of the range is stable; then how deep the
/// selected speed may go.
std::vector<report::Finding> findingsOf(const SafeSpeed& safe, bool is_relative, const char* speedKey);

}  // namespace lathelier::stability
