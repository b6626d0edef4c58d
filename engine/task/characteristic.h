// The numbers of an outcome as a series keeps them, one by one: value, uncertainty, limits and verdict under a key that
// is the same for every part evaluated by the same recipe.
//
// They follow the object of the result (quantitiesOf() of the rooms), whose keys and units are the contract of the
// command line:
//   - a number at `a.b_mm` is the characteristic "a.b_mm"; of a list whose items have a name, a section or a verdict
//     the items count, by name, section or place ("zones.seat.mean_mm", "profiles.1.circles.MZCI.RONt_um"); findings,
//     of which each part has others, are none; other lists are curves, and so are objects that hold a list of more than
//     three numbers (a histogram, a map);
//   - beside a number x_UNIT, x_expanded_uncertainty_UNIT is its U; beside value_, mean_ or deviation_UNIT so is
//     uncertainty_UNIT, limit_UNIT is the limit of its size, lower_ and upper_UNIT are its limits, `verdict` its
//     verdict;
//   - "answer" is the value of the answer strip, with the U, limits and verdict that are shown there.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/json.h"
#include "engine/task/task.h"

namespace lathelier::task {

struct Characteristic {
    std::string key;                             ///< with its unit: "worst.deviation_mm"; "answer"
    std::string unit;                            ///< as shown, "µm"; empty: none
    double value = 0;                            ///< finite, in `unit`
    std::optional<double> expanded_uncertainty;  ///< k = 2 or 95 %, in `unit`; none: not known
    std::optional<double> lower_limit;           ///< in `unit`; none: no limit on this side
    std::optional<double> upper_limit;
    std::optional<Verdict> verdict;  ///< none: not judged
    friend bool operator==(const Characteristic&, const Characteristic&) = default;
};

/// The unit of this text (Characteristic::unit), for axes and tables; empty: not known.
Text unitNamed(std::string_view shown);

/// "zones.seat.mean" of "zones.seat.mean_mm".
std::string withoutUnit(const std::string& key);

/// Of a result object as Outcome::json() gives it, in its order. Keys are unique.
std::vector<Characteristic> characteristicsOf(const Json& result);

/// The answer first, then those of the result. Verdicts are none where something that counts was not understood.
std::vector<Characteristic> characteristicsOf(const Outcome& outcome);

Json toJson(const Characteristic& characteristic);

/// The reverse; none: not such an object.
std::optional<Characteristic> characteristicFrom(const Json& json);

}  // namespace lathelier::task
