// What a part is made with, where nobody stated it.
#pragma once

#include <functional>
#include <string>

#include "engine/shaft/shaft.h"
#include "engine/task/task.h"

namespace lathelier::walk {

/// A part as it is clamped, and the speeds that it is cut at.
struct HeldPart {
    Shaft body;
    Interval speeds_rpm;
};

/// Of a shop (shop_supply.h).
struct Supply {
    std::string digest;  ///< of all that it gives; equal: the same

    /// Whether inputs of this kind of item can be filled.
    std::function<bool(const std::string& kind)> has;

    /// Whether they are made for a part and need one.
    std::function<bool(const std::string& kind)> needs_part;

    /// Of the job that the project states for its part, which fill() and held() follow.
    std::function<std::string(const project::Project&)> job_digest;

    /// Fills the free inputs of the task; `part`: none where there is none yet. Errors of the supply and of the job.
    std::function<void(project::PanelState&, const task::Task&, const Shaft* part, const project::Project&, Stores&,
                       const Progress&, Notes&)>
        fill;

    /// The part with the rest of its bar, as the job of the project or of the supply clamps it. Errors of the job.
    std::function<HeldPart(const Shaft& part, const project::Project&, Stores&, const Progress&, Notes&)> held;
};

}  // namespace lathelier::walk
