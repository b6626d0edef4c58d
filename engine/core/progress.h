// Nested progress and cancellation of a computation.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

#include "engine/core/text.h"

namespace lathelier {

/// Reports how far a computation is and throws Cancelled once it is stopped. Cheap to copy, safe from any thread.
/// Rule: every loop calls report() or check() at least every 20 ms.
class Progress {
public:
    using Show = std::function<void(double fraction, Text stage)>;

    Progress() = default;  ///< reports nothing and is never stopped
    Progress(std::stop_token stop, Show show);

    /// The share [from, to] of this progress, under its own name when `stage` is given.
    Progress part(double from, double to, Text stage = {}) const;

    /// The same stop without reports: for a callee that runs several times side by side.
    Progress quiet() const;

    /// Reports `fraction` (0…1) of this share. Throws Cancelled.
    void report(double fraction) const;

    /// Throws Cancelled when stopped.
    void check() const;

    bool stopped() const { return stop_.stop_requested(); }

private:
    std::stop_token stop_;
    std::shared_ptr<const Show> show_;
    double from_ = 0;
    double to_ = 1;
    Text stage_;
};

}  // namespace lathelier
