// Question of the task surface: acquisition and cutting data of the pictures, or parameters of a generated picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/surface/surface.h"
#include "engine/surface/synthetic.h"

namespace lathelier::surface {

inline constexpr const char* beforeRole = "before";  ///< of the command line all pictures
inline constexpr const char* afterRole = "after";    ///< of a window
inline constexpr const char* speedBeforeKey = "speed_before_rpm";
inline constexpr const char* speedAfterKey = "speed_after_rpm";
inline constexpr const char* spareRegionsKey = "spare_regions";
inline constexpr const char* makeKey = "make_picture";
inline constexpr const char* madePrefix = "made.";  ///< of the keys of SurfaceQuestion::made
inline constexpr const char* quizKey = "quiz";      ///< and what all of its parameters begin with
inline constexpr const char* quizNumberKey = "quiz_number";
inline constexpr const char* quizAnswerKey = "quiz_answer_hz";
inline constexpr const char* layRightKey = "lay_right_px";
inline constexpr const char* layDownKey = "lay_down_px";

/// A picture that shows what marks of chatter look like.
SyntheticParameters demonstration();

/// What stands behind the parameters of the evaluation is kept in a window.
struct SurfaceQuestion {
    SurfaceParameters surface;
    std::optional<double> speed_before_rpm;          ///< of the first picture's cut; none: not known
    std::optional<double> speed_after_rpm;           ///< of the second one's; none: as the first
    bool spare_regions = false;                      ///< regions beyond the pictures: of pictures taken away
    std::string lighting;                            ///< how the light fell, in words; empty: not stated
    bool taken_alike = true;                         ///< both pictures have one scale and direction
    std::optional<double> after_mm_per_px;           ///< else: of the second picture; none: as the first
    std::optional<double> after_feed_direction_deg;  ///< else: of the second picture; none: as the first
    std::optional<double> lay_right_px;              ///< what was clicked in both: the second picture lies so far…
    std::optional<double> lay_down_px;               ///< …from the first, in pixels of the comparison
    bool make_picture = false;                       ///< a picture is made in place of the files
    SyntheticParameters made = demonstration();      ///< how
    bool quiz = false;                               ///< the picture that is made is a question
    int quiz_number = 1;                             ///< number of the question
    std::optional<double> quiz_answer_hz;            ///< of whoever was asked; none: not answered yet
};

const std::vector<Field<SurfaceQuestion>>& fieldsOf(const SurfaceQuestion*);

/// Whether a picture is generated instead of read from files.
bool makesPicture(const Values& parameters);

/// Whether scale and direction apply to both pictures.
bool areTakenAlike(const Values& parameters);

/// Whether a question is open, so that results of the generated picture are hidden.
bool isAsking(const SurfaceQuestion& question);

/// For the evaluation of so many pictures. The speeds before and after, where one is given, rule over the list. Of a
/// picture that is made, the cut is that of the picture.
SurfaceParameters parametersOf(const SurfaceQuestion& question, std::size_t pictures);

/// The same as the command line states them: without what parametersOf() settles.
Values statedValues(const SurfaceQuestion& question, std::size_t pictures, Values parameters);

/// Scale and direction of the second picture where they are its own.
void applyOwnScale(NamedImage& after, const SurfaceQuestion& question);

/// The picture that is made: with room for the whole width of the part where that is asked; that of a question.
SyntheticParameters pictureOf(const SurfaceQuestion& question);

}  // namespace lathelier::surface
