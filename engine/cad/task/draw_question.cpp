#include "engine/cad/task/draw_question.h"

#include <algorithm>

#include "engine/core/field_within.h"

namespace lathelier::cad {
namespace {

/// The tables are edited in a window only.
std::vector<Field<DrawQuestion>> kept(std::vector<Field<DrawQuestion>> all)
{
    for (Field<DrawQuestion>& field : all)
        for (const char* key : {task::segmentsKey, task::segmentsOfKey, boresKey, boresOfKey})
            if (field.info.key == key) field.info.is_kept = true;
    return all;
}

const Text boresLabel = LT_TEXT("Engine", "Bores");
const Text boresHelp =
    LT_TEXT("Engine", "From the mouth inward. A file fills the table; once it is changed, it rules.");

}  // namespace

const std::vector<Field<BoreRow>>& fieldsOf(const BoreRow*)
{
    using B = BoreRow;
    static const auto all = [] {
        std::vector<Field<B>> fields = described<B>(field(
            "from", &B::from, {{"free", LT_TEXT("Engine", "free end")}, {"chuck", LT_TEXT("Engine", "chuck end")}},
            Label{LT_TEXT("Engine", "From"), LT_TEXT("Engine", "The end that its mouth is at.")}));
        for (const Field<BoreSegment>& inner : lathelier::fields<BoreSegment>())
            fields.push_back(within(&B::row, inner.info.key));
        return fields;
    }();
    return all;
}

std::vector<BoreRow> rowsOfBores(const std::vector<ShaftBore>& bores)
{
    std::vector<BoreRow> rows;
    for (const ShaftBore& bore : bores)
        for (const BoreSegment& row : bore.segments) rows.push_back({bore.from, row});
    return rows;
}

std::vector<ShaftBore> boresOfRows(const std::vector<BoreRow>& rows)
{
    std::vector<ShaftBore> bores;
    for (const BoreRow& row : rows) {
        auto own = std::find_if(bores.begin(), bores.end(), [&](const ShaftBore& b) { return b.from == row.from; });
        if (own == bores.end()) own = bores.insert(bores.end(), ShaftBore{row.from, {}});
        own->segments.push_back(row.row);
    }
    return bores;
}

std::string boresOf(const project::PanelState& state)
{
    return "of " + task::identity(state, shaftRole);
}

void setBores(project::PanelState& state, const std::vector<ShaftBore>& bores)
{
    DrawQuestion question;
    question.bores = rowsOfBores(bores);
    set(state.parameters, boresKey, *find(toValues(question), boresKey));
    set(state.parameters, boresOfKey, boresOf(state));
}

const std::vector<Field<DrawQuestion>>& fieldsOf(const DrawQuestion*)
{
    using Q = DrawQuestion;
    static const auto all = kept(described<Q>(
        rows(task::segmentsKey, &Q::segments, Range{0, 10000}, task::segmentsLabel()),
        field(task::segmentsOfKey, &Q::segments_of, task::segmentsOfLabel()),
        rows(boresKey, &Q::bores, Range{0, 1000}, Label{boresLabel, boresHelp}),
        field(boresOfKey, &Q::bores_of,
              Label{LT_TEXT("Engine", "Bores changed from"),
                    LT_TEXT("Engine", "The input that the table of bores was changed from.")}),
        field("name", &Q::name,
              Label{LT_TEXT("Engine", "Part name"),
                    LT_TEXT("Engine", "In the title block and in all files; empty: as the input has it.")}),
        within(&Q::title, "library_material"), within(&Q::title, "material_name"),
        within(&Q::title, "general_tolerances"), within(&Q::title, "surface_texture"), within(&Q::title, "author"),
        within(&Q::title, "date"),
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
        field("measured", &Q::measured,
              Label{LT_TEXT("Engine", "Measured values"),
                    LT_TEXT("Engine", "Sizes in whose place no nominal one was put are set in italics.")}),
        within(&Q::cad, "step_schema"), within(&Q::cad, "dxf_contour"), within(&Q::cad, "undated"),
        field("check", &Q::check,
              Label{LT_TEXT("Engine", "Check only"), LT_TEXT("Engine", "Check the shaft and write nothing.")})));
    return all;
}

}  // namespace lathelier::cad
