// What a photograph says beyond its numbers, and what it cannot say: sentences as patterns with values.
// Source: chatter_geometry.h for ν and ε; P. Jasiewicz and K. Miądlicki, "An integrated CNC system for chatter
// suppression in turning", eq. 23, for N = 60 f / k.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/report/document.h"
#include "engine/surface/surface.h"

namespace lathelier::surface {

/// For which of the two relations between speed and frequency the marks speak.
enum class Referee { Neither, Published, Exact };

/// By |ν|: about ¼ is the exact relation's worst speed, about 0 that of N = 60 f / k.
Referee refereeOf(const ChatterMarks& chatter);

/// "The rule N = 60 f/k puts the worst speed at ν = 0 …; here ν = -0.256: this speaks for the exact relation." None
/// without chatter marks or without the directions that give ν its sign.
std::optional<report::Paragraph> refereeSentence(const ImageMarks& image, const SurfaceParameters& parameters,
                                                 const Language& language = {});

/// Regenerative or forced, by ν.
std::optional<report::Paragraph> originSentence(const ImageMarks& image, const Language& language = {});

/// Whether the picture decides m, and what would.
std::optional<report::Paragraph> certaintySentence(const ImageMarks& image, const Language& language = {});

/// Heights, roughness and amplitudes cannot be told.
report::Paragraph pictureCannot();

/// "Before: marks of 361.0 ± 3.6 Hz … After, 2154 rpm: no chatter marks above 2 % of the feed marks." One paragraph for
/// each of the first two pictures; empty for one picture.
std::vector<report::Paragraph> beforeAndAfter(const SurfaceResult& result, const Language& language = {});

/// Whether both pictures show one surface, and how they were brought together; none for one picture.
std::optional<report::Paragraph> alignmentSentence(const SurfaceResult& result, const Language& language = {});

/// A speed with a whole number of waves in a revolution: the middle of a stable pocket by the exact relation, where
/// the vibration keeps its frequency. N = 60 f_c / k.
struct WholeWaveSpeed {
    int k = 0;             ///< waves in a revolution
    double speed_rpm = 0;  ///< of the spindle
};

/// The two below and the two above the speed of the cut, the fastest last; empty without a frequency.
std::vector<WholeWaveSpeed> wholeWaveSpeeds(const ImageMarks& image);

/// The same as a table, for reports.
report::Table speedTable(const ImageMarks& image);

/// All of these by heading: what is seen, which vibration (none without chatter marks in the first picture), what a
/// picture cannot say.
std::vector<report::Section> surfaceWords(const SurfaceResult& result, const Language& language = {});

}  // namespace lathelier::surface
