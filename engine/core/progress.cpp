#include "engine/core/progress.h"

#include <algorithm>

#include "engine/core/error.h"

namespace lathelier {

Progress::Progress(std::stop_token stop, Show show)
    : stop_(std::move(stop)), show_(show ? std::make_shared<const Show>(std::move(show)) : nullptr)
{
}

Progress Progress::part(double from, double to, Text stage) const
{
    Progress result = *this;
    result.from_ = from_ + from * (to_ - from_);
    result.to_ = from_ + to * (to_ - from_);
    if (!stage.empty()) result.stage_ = stage;
    return result;
}

Progress Progress::quiet() const
{
    Progress result = *this;
    result.show_ = nullptr;
    return result;
}

void Progress::report(double fraction) const
{
    check();
    if (show_) (*show_)(from_ + std::clamp(fraction, 0.0, 1.0) * (to_ - from_), stage_);
}

void Progress::check() const
{
    if (stop_.stop_requested()) throw Cancelled();
}

}  // namespace lathelier
