#include "widgets/chatter_common/understood_models.h"

#include <QCoreApplication>

#include "engine/core/units.h"
#include "engine/io/frf/frf_input.h"
#include "engine/io/shaft/shaft_input.h"
#include "engine/receptance/spindle/spindle_input.h"
#include "engine/task/inputs.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/language.h"

namespace lathelier::chatter_common {
namespace {

struct ModelFacts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::chatter_common::ModelFacts)
};

}  // namespace

QString understoodModel(const project::Source& source, Stores& stores)
{
    if (const auto loaded = stores.of<task::CacheOf<io::FrfInput>>()->known(source)) {
        const auto& frfs = loaded->file.frfs;
        const std::size_t lines = frfs.empty() ? 0 : frfs.front().frf.frequency_hz.size();
        const QString amount = ModelFacts::tr("%L1 lines").arg(lines);
        return understoodText(
            loaded->file.facts,
            frfs.size() > 1 ? ModelFacts::tr("%L1 responses · %2").arg(frfs.size()).arg(amount) : amount);
    }
    if (const auto loaded = stores.of<task::CacheOf<receptance::SpindleInput>>()->known(source))
        return understoodText(loaded->file.facts,
                              loaded->file.spindle.springs() ? ModelFacts::tr("springs") : ModelFacts::tr("table"));
    if (const auto loaded = stores.of<task::CacheOf<io::ShaftInput>>()->known(source)) {
        const Shaft& shaft = loaded->file.shaft;
        return understoodText(loaded->file.facts, ModelFacts::tr("%L1 segments · %2")
                                                      .arg(shaft.segments.size())
                                                      .arg(screenQuantity(shaft.length_mm(), unit::mm, 1)));
    }
    return {};
}

}  // namespace lathelier::chatter_common
