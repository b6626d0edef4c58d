// Checks of "Verify installation": reference data with known results, and the deviation of this program on this
// computer. A room describes its checks; engine/verify collects them.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/text.h"

namespace lathelier {

/// All sets that check one thing.
struct VerifyKind {
    std::string kind;              ///< stable key, "minimum_zone_circle"
    Text name;                     ///< for people
    int sets = 0;                  ///< number of reference data sets checked
    double largest_deviation = 0;  ///< from the known answers
    Text unit;                     ///< empty: relative
    double limit = 0;              ///< largest deviation that passes, in `unit`
    bool pass = false;             ///< largest_deviation ≤ limit
};

/// The checks of one room.
struct VerifyPart {
    std::string key;  ///< of the room, "form"
    std::vector<std::function<VerifyKind(const Progress&)>> checks;
    /// A check on reference data in a folder that the user names; none: the room has no such data.
    std::function<VerifyKind(const std::string& directory, const Progress&)> of_directory = {};
    std::string topic = {};  ///< by which checks are chosen, "dynamics"; empty: the room's key
};

/// Gathers the deviations of one kind.
class VerifyTally {
public:
    VerifyTally(std::string kind, Text name, Text unit, double limit)
    {
        kind_.kind = std::move(kind);
        kind_.name = name;
        kind_.unit = unit;
        kind_.limit = limit;
    }
    void nextSet() { ++kind_.sets; }
    void compare(double found, double expected) { take(std::abs(found - expected)); }
    void take(double deviation)
    {
        // NaN is kept, and fails.
        if (std::isnan(kind_.largest_deviation)) return;
        if (!(deviation <= kind_.largest_deviation)) kind_.largest_deviation = deviation;
    }
    VerifyKind done()
    {
        kind_.pass = kind_.sets > 0 && kind_.largest_deviation <= kind_.limit;
        return kind_;
    }

private:
    VerifyKind kind_;
};

}  // namespace lathelier
