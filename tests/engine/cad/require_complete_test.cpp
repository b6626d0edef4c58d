// A shaft that is not complete is refused with the reason.
#include <gtest/gtest.h>

#include "engine/cad/task/recognize_task.h"
#include "engine/features/features_codes.h"
#include "engine/shaft/shaft_codes.h"

namespace lathelier::cad {
namespace {

std::string reasonOf(const features::Recognition& result)
{
    try {
        requireComplete(result);
    } catch (const Error& error) {
        EXPECT_EQ(error.code().key, errors::shaftIncomplete.key);
        const Value* reason = find(error.values(), "reason");
        const auto* text = reason ? std::get_if<Text>(reason) : nullptr;
        return text ? text->english : "";
    }
    return "complete";
}

TEST(RequireComplete, StatesWhatIsMissing)
{
    features::Recognition whole;
    whole.length_mm = 100;
    EXPECT_EQ(reasonOf(whole), "complete");
    features::Recognition bore = whole;
    bore.complete = false;
    bore.notes.push_back({notes::boreNotSeen, {{"z_start_mm", 10.0}, {"z_end_mm", 20.0}}});
    EXPECT_EQ(reasonOf(bore), "a bore is not seen over its whole length");
    features::Recognition end = whole;
    end.complete = false;
    end.length_mm.reset();
    EXPECT_EQ(reasonOf(end), "an end is not seen or undecided; state the length to confirm it (--length-mm)");
    features::Recognition gap = end;
    gap.gaps.push_back({10, 20});
    EXPECT_EQ(reasonOf(gap), "there is a gap in the data");
}

}  // namespace
}  // namespace lathelier::cad
