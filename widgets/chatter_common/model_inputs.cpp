#include "widgets/chatter_common/model_inputs.h"

#include <QCoreApplication>

#include "engine/core/frf_item.h"
#include "engine/core/units.h"
#include "widgets/chatter_common/frf_files.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/chatter_common/shaft_files.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"

namespace lathelier::chatter_common {
namespace {

struct ModelFacts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::chatter_common::ModelFacts)
};

}  // namespace

InputRole inputRole(const char* role, Text label, Text hint, const io::FileKind& kind, const char* item)
{
    InputRole input;
    input.role = role;
    input.label = label;
    input.hint = hint;
    input.kinds = {&kind};
    input.item_kind = item;
    return input;
}

InputRole responseRole(Text hint)
{
    InputRole role = inputRole(frfRole, LT_TEXT("Engine", "Frequency response"), hint, io::frfFiles(), frfItem);
    role.required = false;
    return role;
}

QString understoodResponse(const project::Source& source, Stores& stores)
{
    const auto loaded = stores.of<FrfStore>()->known(source);
    if (!loaded) return {};
    const auto& frfs = loaded->file.frfs;
    const std::size_t lines = frfs.empty() ? 0 : frfs.front().frf.frequency_hz.size();
    const QString amount = ModelFacts::tr("%L1 lines").arg(lines);
    return understoodText(loaded->file.facts,
                          frfs.size() > 1 ? ModelFacts::tr("%L1 responses · %2").arg(frfs.size()).arg(amount) : amount);
}

void assignModels(project::PanelState& state, const std::vector<FoundFile>& files)
{
    for (const FoundFile& file : files)
        state.inputs[file.kind == &io::shaftFiles() ? shaftRole : spindleRole] =
            newSource(QString::fromStdString(file.path));
}

QString understoodModel(const std::string& role, const project::Source& source, Stores& stores)
{
    if (role == spindleRole) {
        const auto loaded = stores.of<SpindleStore>()->known(source);
        if (!loaded) return {};
        return understoodText(loaded->file.facts,
                              loaded->file.spindle.springs() ? ModelFacts::tr("springs") : ModelFacts::tr("table"));
    }
    const auto loaded = stores.of<ShaftStore>()->known(source);
    if (!loaded) return {};
    const Shaft& shaft = loaded->file.shaft;
    return understoodText(loaded->file.facts, ModelFacts::tr("%L1 segments · %2")
                                                  .arg(shaft.segments.size())
                                                  .arg(screenQuantity(shaft.length_mm(), unit::mm, 1)));
}

}  // namespace lathelier::chatter_common
