#include "widgets/shaft/shaft_picture.h"

#include <limits>

#include "engine/io/frf/frf_lines.h"
#include "engine/receptance/receptance_codes.h"
#include "widgets/chatter_common/shaft_files.h"
#include "widgets/part_common/shaft_table.h"

namespace lathelier::shaft_panel {
namespace {

void chooseShaft(ShaftPicture& picture, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const ShaftQuestion& question = picture.question;
    picture.table_rules = part_common::chooseSegments(
        question.segments, question.segments_of, state, picture.shaft, picture.notes, [&](const project::Source&) {
            picture.shaft = chatter_common::noted(picture, *chatter_common::takeShaft(state, stores, progress));
        });
}

/// The material by whom stated it: the user, the library, the file. None: steel is assumed.
ValueOrigin chooseMaterial(ShaftPicture& picture)
{
    if (picture.question.own_material) {
        picture.shaft.material = picture.question.own_material;
        return ValueOrigin::Given;
    }
    const bool chosen = part_common::chooseMaterial(picture.question.material, picture.shaft, picture.notes);
    return !chosen && picture.shaft.material ? ValueOrigin::File : ValueOrigin::Assumed;
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
