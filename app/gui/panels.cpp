#include "app/gui/panels.h"

namespace lathelier {

const std::vector<PanelFacts>& panelTable()
{
    static const std::vector<PanelFacts> table{};
    return table;
}

}  // namespace lathelier
