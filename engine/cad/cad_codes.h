// Errors and notes of CAD files: codes with their English patterns. {name} is replaced by the named value; text() puts
// path, line, column and byte in front, so patterns do not repeat them. For STEP files that are not turned parts,
// notABodyOfRevolution of registration is used.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode solidNotBuilt{"solid_not_built", ErrorKind::NoAnswer,
                                         LT_TEXT("Engine", "No valid solid can be made of this shaft: {reason}.")};

inline constexpr ErrorCode solidVolumeWrong{
    "solid_volume_wrong", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "The solid made of this shaft has {found_mm3} mm³ instead of {expected_mm3} mm³; it is not written.")};

inline constexpr ErrorCode noSolid{
    "no_solid", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The STEP file holds no solid; wireframes and loose surfaces do not bound a part.")};

inline constexpr ErrorCode severalParts{
    "several_parts", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The STEP file holds several parts: {count} solids. One turned part is expected.")};

inline constexpr ErrorCode stepTooLarge{
    "step_too_large", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The STEP file has {found} {items}; at most {maximum} are read.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode marksLeftOut{
    "marks_left_out", Severity::Warning,
    LT_TEXT("Engine",
            "Marks that no body of revolution shows, left out of the CAD file: {count} ({kinds}); its volume is that "
            "of the plain body. The drawing shows them.")};

inline constexpr NoteCode arcBeyondAxis{
    "arc_beyond_axis", Severity::Info,
    LT_TEXT("Engine",
            "Row {row} of the contour is an arc whose centre lies beyond the axis: a surface of revolution in STEP, "
            "no torus.")};

inline constexpr NoteCode notOfRevolution{
    "not_of_revolution", Severity::Warning,
    LT_TEXT("Engine",
            "Faces that are not of revolution about the axis: {count}, {area_mm2} mm² of {total_mm2} mm²; the volume "
            "of the part is {volume_percent} % of the turned body's.")};

}  // namespace notes

}  // namespace lathelier
