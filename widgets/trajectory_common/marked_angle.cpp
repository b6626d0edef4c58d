#include "widgets/trajectory_common/marked_angle.h"

namespace lathelier::trajectory_common {

void MarkedAngle::takeBack()
{
    set(before_deg_);
}

void MarkedAngle::set(std::optional<double> angle_deg)
{
    if (angle_deg == angle_deg_) return;
    before_deg_ = angle_deg_;
    angle_deg_ = angle_deg;
    emit changed();
}

}  // namespace lathelier::trajectory_common
