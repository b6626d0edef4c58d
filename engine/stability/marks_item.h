// Chatter marks evaluated from a photograph, as an item of the project, for comparison of the observed chatter
// frequency with that of the lobe model.
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
    double speed_rpm = 0;                    ///< spindle speed of the cut
    double frequency_hz = 0;                 ///< of the vibration
    double uncertainty_hz = 0;               ///< standard uncertainty of the frequency
    std::optional<double> nearest_other_hz;  ///< distance to the nearest alternative reading of the marks; none: unique
};

/// Values of the item.
Values toValues(const SurfaceMarks& marks);

/// Inverse of toValues(); none if the values do not describe marks.
std::optional<SurfaceMarks> marksOf(const Values& values);

/// The frequency of the marks against that of a model at the same speed.
struct ModelCheck {
    double model_hz = 0;            ///< chatter frequency at the limit
    double difference_percent = 0;  ///< deviation of the marks from the model
    bool agrees = false;            ///< within modelTolerance_percent
};

/// Larger deviations indicate an error in response, diameter, speed or number of waves.
inline constexpr double modelTolerance_percent = 5;

/// None if no lobe limits at that speed.
std::optional<ModelCheck> checkModel(const SurfaceMarks& marks, const LobeResult& lobes);

/// "Your marks say 223.0 ± 2.2 Hz, your model says 221 Hz; the nearest other reading is 46.7 Hz away."
report::Finding modelFinding(const SurfaceMarks& marks, const ModelCheck& check, const Language& language = {});

/// A vertical line at the speed of the marks, for the lobe chart.
void drawMarks(report::Plot& lobes, const SurfaceMarks& marks, const Language& language = {});

/// The line, and a dot at speed and frequency, for the chart of the chatter frequency.
void drawMarksFrequency(report::Plot& frequencies, const SurfaceMarks& marks, const Language& language = {});

}  // namespace lathelier::stability
