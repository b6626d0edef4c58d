#include "widgets/drawing/drawing_question.h"

namespace lathelier::drawing_panel {

const std::vector<Field<DrawingQuestion>>& fieldsOf(const DrawingQuestion*)
{
    using Q = DrawingQuestion;
    static const auto all = described<Q>(
        rows(segmentsKey, &Q::segments, Range{0, 10000}, part_common::segmentsLabel()),
        field(segmentsOfKey, &Q::segments_of, part_common::segmentsOfLabel()),
        field("name", &Q::name,
              Label{LT_TEXT("Engine", "Part name"),
                    LT_TEXT("Engine", "In the title block and in all files; empty: as the input has it.")}),
        field("material", &Q::material, chatter_common::materialChoices(LT_TEXT("Engine", "as the file states")),
              Label{LT_TEXT("Engine", "Material"),
                    LT_TEXT("Engine", "Handbook values of the library are marked as assumed.")}),
        field("material_name", &Q::material_name,
              Label{LT_TEXT("Engine", "Material name"),
                    LT_TEXT("Engine", "As printed in the title block; empty: the name of the material.")}),
        field("sheet", &Q::sheet,
              {{"auto", LT_TEXT("Engine", "automatic")},
               {"a4", LT_TEXT("Engine", "A4")},
               {"a4_portrait", LT_TEXT("Engine", "A4 portrait")},
               {"a3", LT_TEXT("Engine", "A3")}},
              Label{LT_TEXT("Engine", "Sheet"),
                    LT_TEXT("Engine", "Automatic: A4, or A3 where A4 would be too small to read.")}),
        field("lengths", &Q::lengths,
              {{"free_end", LT_TEXT("Engine", "from the free end")}, {"chain", LT_TEXT("Engine", "as a chain")}},
              Label{LT_TEXT("Engine", "Lengths"),
                    LT_TEXT("Engine",
                            "How the drawing gives lengths, and what an edited one leaves in place: from the free end "
                            "all other shoulders, as a chain all other lengths.")}),
        field("date", &Q::date, Label{LT_TEXT("Engine", "Date"), LT_TEXT("Engine", "As printed; empty: today.")}),
        field("measured", &Q::measured,
              Label{LT_TEXT("Engine", "Measured values"),
                    LT_TEXT("Engine", "Sizes in whose place no nominal one was put are set in italics.")}));
    return all;
}

}  // namespace lathelier::drawing_panel
