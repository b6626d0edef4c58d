// Errors and notes of the evaluation of photographs: codes with their English patterns. {name} is replaced by the named
// value; text() puts the path in front where there is one.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode pictureTooSmall{
    "picture_too_small", ErrorKind::InputRejected,
    LT_TEXT("Engine", "A picture of {width} × {height} px is too small: at least {minimum} px are needed either way.")};

inline constexpr ErrorCode feedNotResolved{
    "feed_not_resolved", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "A feed of {feed_mm_rev} mm is {found_px} px wide; at least {needed_px} px are needed, that is "
            "{needed_mm_per_px} mm/px or finer. Photograph closer.")};

inline constexpr ErrorCode feedAliased{
    "feed_aliased", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "A feed of {feed_mm_rev} mm is {found_px} px wide; at least {needed_px} px are needed. The marks of "
            "{alias_px} px in the picture are its alias. Photograph closer.")};

inline constexpr ErrorCode scaleNotStated{
    "scale_not_stated", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The file states no size of its pixels; give the scale by another option.")};

inline constexpr ErrorCode regionOutside{
    "region_outside", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "The region {found} does not lie in the picture of {width} × {height} px.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode pitchDiffersFromFeed{
    "pitch_differs_from_feed", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: the marks are {pitch_mm} mm apart, the feed is {feed_mm_rev} mm. Scale or feed is wrong, or the "
            "marks are an alias.")};

inline constexpr NoteCode sameLightingAssumed{
    "same_lighting_assumed", Severity::Info,
    LT_TEXT("Engine", "The pictures are compared as if camera and light had been the same."), NoteRole::Assumed};

inline constexpr NoteCode directionsUnknown{
    "directions_unknown", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: without the directions of feed and cut the sign of ν is open: {first_hz} or {second_hz} Hz. The "
            "usual, regenerative reading stands first.")};

inline constexpr NoteCode wavesUncertain{
    "waves_uncertain", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: only {waves} waves lie in the picture; the whole number of waves in a revolution is open. "
            "Photograph the whole width of the part, or choose among the candidates.")};

inline constexpr NoteCode chosenByExpectation{
    "chosen_by_expectation", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: {frequency_hz} Hz was chosen because {expected_hz} Hz was expected; the picture alone "
            "does not decide.")};

inline constexpr NoteCode pictureSaturated{
    "picture_saturated", Severity::Warning,
    LT_TEXT("Engine", "{path}: {percent} % of the pixels are black or white; the marks there are lost.")};

inline constexpr NoteCode feedFewPixels{
    "feed_few_pixels", Severity::Warning,
    LT_TEXT("Engine", "{path}: a feed is {found_px} px wide; {wanted_px} px are better.")};

inline constexpr NoteCode scaleFromFeed{
    "scale_from_feed", Severity::Info,
    LT_TEXT("Engine", "{path}: the scale was taken from the feed; the pitch is no check of it then.")};

inline constexpr NoteCode scaleFromFile{
    "scale_from_file", Severity::Info,
    LT_TEXT("Engine", "{path}: the scale was taken from the file, {um_per_px} µm per pixel."), NoteRole::Assumed};

inline constexpr NoteCode twoFeeds{
    "two_feeds", Severity::Warning,
    LT_TEXT(
        "Engine",
        "{path}: marks of two feeds lie in the picture, {pitch} and {second_pitch} {unit} apart, in different parts "
        "of it. Chatter was not looked for; evaluate each part by itself with a region.")};

inline constexpr NoteCode lessThanOneWave{
    "less_than_one_wave", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: a pattern of {waves} waves in a revolution was found, {least} at the least. Light may double one "
            "wave, and less than one is no vibration of the cut: drift, light, a second feed or the scale make it. "
            "Whether there is chatter is undecided; photograph more of the circumference."),
    NoteRole::NotModelled};

inline constexpr NoteCode scaleUnknown{"scale_unknown", Severity::Info,
                                       LT_TEXT("Engine", "{path}: no scale is given; lengths are in pixels only.")};

inline constexpr NoteCode pictureUnrolled{"picture_unrolled", Severity::Info,
                                          LT_TEXT("Engine", "{path}: the cylinder was unrolled over {span_deg}°.")};

inline constexpr NoteCode curvatureIgnored{
    "curvature_ignored", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: the part curves away across the picture and was not unrolled; the whole number of waves "
            "in a revolution is open.")};

inline constexpr NoteCode axisUnknown{
    "axis_unknown", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: neither feed marks nor a direction of feed tell where the axis lies; the part may curve away "
            "across the picture and was not unrolled.")};

inline constexpr NoteCode modelNotUsed{
    "model_not_used", Severity::Warning,
    LT_TEXT("Engine", "The marks were not compared with the frequency response: {reason}")};

inline constexpr NoteCode notRegistered{
    "pictures_not_registered", Severity::Info,
    LT_TEXT("Engine",
            "The pictures show different surfaces (response {response}); they are aligned by scale and direction "
            "only.")};

}  // namespace notes

}  // namespace lathelier
