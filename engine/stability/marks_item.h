// Chatter marks that were read off a surface, as an item of the project: the picture of the surface says at which
// frequency the cut really chattered, the lobe chart where a model puts it.
#pragma once

#include <optional>
#include <string>

#include "engine/core/value.h"
#include "engine/report/answer.h"
#include "engine/report/chart.h"
#include "engine/stability/lobes.h"

namespace lathelier::stability {

inline constexpr const char* marksItem = "chatter_marks";  ///< kind of the item

struct SurfaceMarks {
    std::string picture;                     ///< name of the file
    double speed_rpm = 0;                    ///< that the surface was cut with
    double frequency_hz = 0;                 ///< of the vibration
    double uncertainty_hz = 0;               ///< standard uncertainty of the frequency
    std::optional<double> nearest_other_hz;  ///< distance to the next reading of the marks; none: there is no other
};

/// Values of the item.
Values toValues(const SurfaceMarks& marks);

/// The same back; nothing when the values are not those of marks.
std::optional<SurfaceMarks> marksOf(const Values& values);

/// The frequency of the marks against that of a model at the same speed.
struct ModelCheck {
    double model_hz = 0;            ///< chatter frequency at the limit
    double difference_percent = 0;  ///< of the marks from the model's
    bool agrees = false;            ///< within modelTolerance_percent
};

/// Beyond it response, diameter, speed or number of waves are to be doubted.
inline constexpr double modelTolerance_percent = 5;

/// Nothing where no lobe limits at that speed.
std::optional<ModelCheck> checkModel(const SurfaceMarks& marks, const LobeResult& lobes);

/// "Your marks say 223.0 ± 2.2 Hz, your model says 221 Hz; the nearest other reading is 46.7 Hz away."
report::Finding modelFinding(const SurfaceMarks& marks, const ModelCheck& check, const Language& language = {});

/// A vertical line at the speed of the marks, for the lobe chart.
void drawMarks(report::Plot& lobes, const SurfaceMarks& marks, const Language& language = {});

/// The line, and a dot at speed and frequency, for the chart of the chatter frequency.
void drawMarksFrequency(report::Plot& frequencies, const SurfaceMarks& marks, const Language& language = {});

}  // namespace lathelier::stability
