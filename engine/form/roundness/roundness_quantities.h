// Description of the roundness results: keys, names, units and decimals for JSON, tables and CSV.
#pragma once

#include "engine/core/quantities.h"
#include "engine/form/roundness/roundness.h"
#include "engine/form/roundness/superimpose.h"

namespace lathelier::form {

const std::vector<QuantityOf<FittedCircle>>& quantitiesOf(const FittedCircle*);
const std::vector<QuantityOf<ReferenceCircles>>& quantitiesOf(const ReferenceCircles*);
const std::vector<QuantityOf<TwoPointSize>>& quantitiesOf(const TwoPointSize*);
const std::vector<QuantityOf<MethodRow>>& quantitiesOf(const MethodRow*);
const std::vector<QuantityOf<RoundnessHint>>& quantitiesOf(const RoundnessHint*);
const std::vector<QuantityOf<PaperValues>>& quantitiesOf(const PaperValues*);
const std::vector<QuantityOf<RoundnessResult>>& quantitiesOf(const RoundnessResult*);
const std::vector<QuantityOf<SuperimposeResult>>& quantitiesOf(const SuperimposeResult*);

/// upr, amplitude_um and phase_deg of each.
Rows harmonicRows(const std::vector<signal::Harmonic>& harmonics);

/// The whole result with its notes, in the form documented for scripts: one element of the command line's `profiles`,
/// without the path.
Json toJson(const RoundnessResult& result);
Json toJson(const SuperimposeResult& result);

}  // namespace lathelier::form
