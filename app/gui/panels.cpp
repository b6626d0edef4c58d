#include "app/gui/panels.h"

#include "widgets/compare/compare_panel.h"

namespace lathelier {

const std::vector<PanelFacts>& panelTable()
{
    static const std::vector<PanelFacts> table{comparePanelFacts()};
    return table;
}

}  // namespace lathelier
