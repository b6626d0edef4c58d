// Error and note codes of image readers, with their English patterns. {name} is replaced by the named value; text()
// prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode imageTooLarge{
    "image_too_large", ErrorKind::InputRejected,
    LT_TEXT("Engine", "A picture of {width} × {height} px is too large: {found} {unit}; at most {maximum} are read.")};

inline constexpr ErrorCode imageEmpty{"image_empty", ErrorKind::InputRejected,
                                      LT_TEXT("Engine", "The picture has no pixels: {width} × {height}.")};

inline constexpr ErrorCode imageImplausible{
    "image_implausible", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "{found_bytes} bytes cannot hold a picture of {width} × {height} px; at least {expected_bytes} are "
            "expected.")};

inline constexpr ErrorCode imageUnsupported{
    "image_unsupported", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Pictures of this kind are not read: found {found}, expected {expected}.")};

inline constexpr ErrorCode imageDamaged{"image_damaged", ErrorKind::InputRejected,
                                        LT_TEXT("Engine", "The picture is damaged at row {row}: {reason}.")};

inline constexpr ErrorCode imageEndsEarly{
    "image_ends_early", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The picture ends early: {row} of {expected} rows are there.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode imageScaleStated{
    "image_scale_stated", Severity::Info,
    LT_TEXT("Engine", "{path}: the file states {um_per_px} µm per pixel; used only when it is given as the scale.")};

inline constexpr NoteCode imageTurned{
    "image_turned", Severity::Info,
    LT_TEXT("Engine", "{path}: the picture was turned or mirrored as its EXIF orientation {orientation} says.")};

inline constexpr NoteCode imageProfileIgnored{
    "image_profile_ignored", Severity::Info,
    LT_TEXT("Engine", "{path}: the colour profile of the picture is not used.")};

inline constexpr NoteCode imageAlphaDropped{"image_alpha_dropped", Severity::Info,
                                            LT_TEXT("Engine", "{path}: the transparency of the picture is not used.")};

inline constexpr NoteCode imagePagesIgnored{
    "image_pages_ignored", Severity::Warning,
    LT_TEXT("Engine", "{path}: only the first of {count} pictures in the file was read.")};

}  // namespace notes

}  // namespace lathelier
