// Errors and notes of shops: codes with their English patterns.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode shopEntryUnknown{"shop_entry_unknown", ErrorKind::InputRejected,
                                            LT_TEXT("Engine", "The shop has no {table} “{key}”; it has {known}.")};

inline constexpr ErrorCode partLargerThanBars{
    "part_larger_than_bars", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "The part's largest diameter is {diameter_mm} mm; bars are listed up to {largest_mm} mm. State a job with "
            "the bar at hand.")};

inline constexpr ErrorCode partLargerThanLathe{
    "part_larger_than_lathe", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{what} is {found_mm} mm; the lathe “{lathe}” takes {most_mm} mm.")};

inline constexpr ErrorCode shopNeedsPart{
    "shop_needs_part", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "The shop makes {what} for a part: state it with {name}, or state {what}.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode ofShop{"of_shop", Severity::Info,
                                 LT_TEXT("Engine", "{what} of the shop: {value} ({source})."), NoteRole::Assumed};

}  // namespace notes

}  // namespace lathelier
