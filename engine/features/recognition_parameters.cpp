#include "engine/core/units.h"
#include "engine/features/recognition.h"

namespace lathelier::features {
namespace {

constexpr double largestLength_mm = 1e5;

Label label(Text name, Text help, Text unit = {})
{
    return {name, help, unit};
}

Label folded(Text name, Text help, Text unit = {})
{
    Label result{name, help, unit};
    result.advanced = true;
    return result;
}

}  // namespace

const std::vector<Field<RecognitionParameters>>& fieldsOf(const RecognitionParameters*)
{
    using P = RecognitionParameters;
    static const auto all = described<P>(
        field("method", &P::method,
              {{"robust", LT_TEXT("Engine", "whole meridian, robust")}, {"paper", LT_TEXT("Engine", "as published")}},
              label(LT_TEXT("Engine", "Method"),
                    LT_TEXT("Engine", "The meridian fitted as a whole, or the sections of the published method."))),
        field("scene", &P::scene,
              {{"auto", LT_TEXT("Engine", "cut what is clearly not the part")},
               {"keep", LT_TEXT("Engine", "keep all")},
               {"cut", LT_TEXT("Engine", "cut")}},
              label(LT_TEXT("Engine", "Besides the part"),
                    LT_TEXT("Engine",
                            "A turntable, clamps and loose things in the scan: automatically cut off are a plane much "
                            "larger than the part, a chuck's jaws or a centre at an end of it, clusters of points."))),
        field("snap", &P::snap,
              {{"suggest", LT_TEXT("Engine", "suggest")},
               {"none", LT_TEXT("Engine", "none")},
               {"apply", LT_TEXT("Engine", "apply")}},
              label(LT_TEXT("Engine", "Nominal sizes"),
                    LT_TEXT("Engine", "Applied ones stand beside what was measured."))),
        field("form_tolerance_mm", &P::form_tolerance_mm, {0, 10},
              label(LT_TEXT("Engine", "Form tolerance"),
                    LT_TEXT("Engine",
                            "On the radius: what one element describes within it is one row; 0: nothing is "
                            "merged."),
                    unit::mm)),
        field(
            "scanner_accuracy_mm", &P::scanner_accuracy_mm, {0, 10},
            label(LT_TEXT("Engine", "Scanner accuracy"),
                  LT_TEXT("Engine", "Of the maker; it is added to every uncertainty. Without it they hold noise only."),
                  unit::mm)),
        field(
            "unexplained", &P::unexplained,
            {{"refuse", LT_TEXT("Engine", "no CAD, no program")}, {"damage", LT_TEXT("Engine", "damage of the part")}},
            label(LT_TEXT("Engine", "Unexplained structure"),
                  LT_TEXT("Engine",
                          "What no row and no mark explains. Damage: a person says that the part was made without "
                          "it."))),
        field("free_end", &P::free_end,
              {{"first", LT_TEXT("Engine", "first of the data")}, {"last", LT_TEXT("Engine", "last of the data")}},
              label(LT_TEXT("Engine", "Free end"),
                    LT_TEXT("Engine", "Where z is 0, along the larger coordinate's sense."))),
        field("length_mm", &P::length_mm, {0.01, largestLength_mm},
              folded(LT_TEXT("Engine", "Length"),
                     LT_TEXT("Engine", "Confirms the length where an end lies outside the scan."), unit::mm)),
        field("exclude_z_mm", &P::exclude_z_mm, {-largestLength_mm, largestLength_mm},
              folded(LT_TEXT("Engine", "Excluded zones"),
                     LT_TEXT("Engine",
                             "Stretches along the recognised axis that are left out: z as in the table without them, "
                             "from the first data at the free end, after things besides the part were cut off."),
                     unit::mm)),
        field("length_of_chucked_mm", &P::length_of_chucked_mm, {0, largestLength_mm},
              folded(LT_TEXT("Engine", "Length in the chuck"),
                     LT_TEXT("Engine", "Kept in the shaft, left out of the stock file."), unit::mm)),
        field("band_width_mm", &P::band_width_mm, {0.001, 100},
              folded(LT_TEXT("Engine", "Section width"), LT_TEXT("Engine", "Of the published method."), unit::mm)),
        field(
            "coverage_percent", &P::coverage_percent, {1, 100},
            folded(LT_TEXT("Engine", "Sections cover"), LT_TEXT("Engine", "Of the published method."), unit::percent)),
        field("radial_tolerance_mm", &P::radial_tolerance_mm, {0.0001, 100},
              folded(LT_TEXT("Engine", "Radial tolerance"), LT_TEXT("Engine", "Of the published method."), unit::mm)),
        field(
            "compare_with", &P::compare_with,
            {{"previous", LT_TEXT("Engine", "the one before")}, {"first", LT_TEXT("Engine", "the first of its step")}},
            folded(LT_TEXT("Engine", "Sections are compared with"), LT_TEXT("Engine", "Of the published method."))));
    return all;
}

}  // namespace lathelier::features
