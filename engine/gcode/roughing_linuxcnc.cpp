#include "engine/gcode/roughing_linuxcnc.h"

namespace lathelier::gcode {

SubroutineCycleMoves subroutineCycle(const SubroutineCycle&, const std::vector<Piece>&)
{
    SubroutineCycleMoves found;
    found.is_modelled = false;
    return found;
}

}  // namespace lathelier::gcode
