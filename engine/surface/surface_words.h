// Sentences on the interpretation of a photograph and its limits, as patterns with values. Source: chatter_geometry.h
// for ν and ε; P. Jasiewicz and K. Miądlicki, "An integrated CNC system for chatter suppression in turning", eq. 23,
// for N = 60 f / k.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/report/document.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// The relation between speed and frequency that is consistent with the marks.
enum class SpeedRelationCheck { Neither, Published, Exact };

/// By |ν|: about ¼ is the exact relation's worst speed, about 0 that of N = 60 f / k.
SpeedRelationCheck speedRelationCheckOf(const ChatterMarks& chatter);

/// "The rule N = 60 f/k puts the worst speed at ν = 0 …; here ν = -0.256: this speaks for the exact relation." None
/// without chatter marks or without the directions that give ν its sign.
std::optional<report::Paragraph> speedRelationSentence(const ImageMarks& image, const SurfaceParameters& parameters,
                                                       const Language& language = {});

/// Origin of the vibration, regenerative or forced, from ν.
std::optional<report::Paragraph> originSentence(const ImageMarks& image, const Language& language = {});

/// Certainty of m, and data that would determine it.
std::optional<report::Paragraph> certaintySentence(const ImageMarks& image, const Language& language = {});

/// States that heights, roughness and absolute amplitudes cannot be determined.
report::Paragraph pictureLimits();

/// "Before: marks of 361.0 ± 3.6 Hz … After, 2154 rpm: no chatter marks above 2 % of the feed marks." One paragraph for
/// each of the first two pictures; empty for one picture.
std::vector<report::Paragraph> beforeAndAfter(const SurfaceResult& result, const Language& language = {});

/// Registration of both pictures; none for one picture.
std::optional<report::Paragraph> alignmentSentence(const SurfaceResult& result, const Language& language = {});

/// A speed with a whole number of waves in a revolution: the middle of a stable pocket by the exact relation, if the
/// vibration frequency is unchanged. N = 60 f_c / k.
struct WholeWaveSpeed {
    int k = 0;  ///< waves in a revolution
    double speed_rpm = 0;
};

/// The two next lower and two next higher speeds, ascending; empty without a frequency.
std::vector<WholeWaveSpeed> wholeWaveSpeeds(const ImageMarks& image);

/// The same as a table, for reports.
report::Table speedTable(const ImageMarks& image);

/// All sentences by section: observation, vibration (only with chatter marks in the first picture), limits of a
/// picture.
std::vector<report::Section> surfaceWords(const SurfaceResult& result, const Language& language = {});

}  // namespace lathelier::surface
