#include "widgets/shaft/shaft_picture.h"

#include <limits>

#include "engine/io/frf/frf_lines.h"
#include "engine/receptance/receptance_codes.h"
#include "widgets/chatter_common/shaft_files.h"

namespace lathelier::shaft_panel {
namespace {

/// What stands for a source in a sentence.
std::string nameOf(const project::Source& source)
{
    return source.item.empty() ? source.path : source.item;
}

/// The table where it was changed; where the file it came from is gone by now, the table is enough.
void chooseShaft(ShaftPicture& picture, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const ShaftQuestion& question = picture.question;
    picture.table_rules = !question.segments.empty() && question.segments_of == identity(state);
    if (const project::Source* source = chatter_common::sourceOf(state, shaftRole)) {
        try {
            picture.shaft = chatter_common::noted(picture, *chatter_common::takeShaft(state, stores, progress));
        } catch (const Error&) {
            if (!picture.table_rules) throw;
        }
        if (picture.table_rules && picture.shaft.segments != question.segments)
            picture.notes.push_back({notes::shaftChanged, {{"source", nameOf(*source)}}});
    }
    if (picture.table_rules || picture.shaft.segments.empty()) picture.shaft.segments = question.segments;
}

/// The material by whom stated it: the user, the library, the file. None: steel is assumed.
ValueOrigin chooseMaterial(ShaftPicture& picture)
{
    if (picture.question.own_material) {
        picture.shaft.material = picture.question.own_material;
        return ValueOrigin::Given;
    }
    const auto [entry, name] = chatter_common::chosen(picture.question.material);
    if (!entry) return picture.shaft.material ? ValueOrigin::File : ValueOrigin::Assumed;
    picture.shaft.material = entry->value;
    picture.notes.push_back({notes::materialOfLibrary, {{"material", name}, {"source", entry->source}}});
    return ValueOrigin::Assumed;
}

void chooseHolding(ShaftPicture& picture, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const ShaftQuestion& question = picture.question;
    receptance::ShaftHolding& holding = picture.holding;
    for (const Rest& rest : question.rests)
        holding.supports.push_back({rest.z_mm, rest.radial_N_mm, 0, rest.loss_factor});
    constexpr double rigid = std::numeric_limits<double>::infinity();
    switch (question.hold) {
        case Hold::Free: return;
        case Hold::Clamped: holding.supports.push_back({picture.shaft.length_mm(), rigid, rigid, 0}); return;
        case Hold::Springs: holding.spindle = receptance::SpindleReceptance{question.springs}; return;
        case Hold::Given: break;
    }
    if (auto spindle = chatter_common::takeSpindle(state, stores, progress))
        holding.spindle = chatter_common::noted(picture, *std::move(spindle));
}

/// A table of the spindle says what range there is.
receptance::ReceptanceParameters responseAsked(const ShaftPicture& picture)
{
    receptance::ReceptanceParameters asked = picture.question.response;
    if (picture.holding.spindle) asked = chatter_common::withinTable(asked, *picture.holding.spindle);
    asked.from_hz = picture.question.from_hz.value_or(asked.from_hz);
    asked.to_hz = picture.question.to_hz.value_or(asked.to_hz);
    return asked;
}

}  // namespace

std::string identity(const project::PanelState& state)
{
    const project::Source* source = chatter_common::sourceOf(state, shaftRole);
    if (!source) return {};
    return source->item.empty() ? source->path : "item " + source->item;
}

ShaftPicture shaftPicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    ShaftPicture picture;
    picture.question = fromValues<ShaftQuestion>(state.parameters);
    chooseShaft(picture, state, stores, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")));
    const ValueOrigin origin = chooseMaterial(picture);
    chooseHolding(picture, state, stores, progress.part(0.1, 0.2));
    picture.study = studyShaft(picture.shaft, responseAsked(picture), picture.holding,
                               progress.part(0.2, 1, LT_TEXT("Engine", "Computing")));
    for (UsedValue& used : picture.study.response.used) used.origin = origin;
    const Notes& found = picture.study.response.notes;
    picture.notes.insert(picture.notes.end(), found.begin(), found.end());
    return picture;
}

Frf usableResponse(const ShaftPicture& picture)
{
    Frf frf = picture.study.response.frf;
    io::dropUnusableLines(frf);
    return frf;
}

}  // namespace lathelier::shaft_panel
