// Description of the results of a comparison, for JSON, report and tables.
#pragma once

#include "engine/core/quantities.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {

const std::vector<QuantityOf<DeviationStatistics>>& quantitiesOf(const DeviationStatistics*);
const std::vector<QuantityOf<WorstPlace>>& quantitiesOf(const WorstPlace*);
const std::vector<QuantityOf<Finding>>& quantitiesOf(const Finding*);
const std::vector<QuantityOf<Zone>>& quantitiesOf(const Zone*);
const std::vector<QuantityOf<FreeMotion>>& quantitiesOf(const FreeMotion*);
const std::vector<QuantityOf<Axis>>& quantitiesOf(const Axis*);
const std::vector<QuantityOf<AlignmentUncertainty>>& quantitiesOf(const AlignmentUncertainty*);
const std::vector<QuantityOf<Alignment>>& quantitiesOf(const Alignment*);
const std::vector<QuantityOf<Histogram>>& quantitiesOf(const Histogram*);

/// Statistics of deviations without a sign are not given, but for the numbers of points.
const std::vector<QuantityOf<CompareResult>>& quantitiesOf(const CompareResult*);

/// All numbers of the result but the deviations of single points. `notes` and `parameters` are not included: the
/// command line adds them for every verb. Numbers that do not exist are null.
Json toJson(const CompareResult& result);

}  // namespace lathelier::registration
