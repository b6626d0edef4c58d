// Results of deflection described once, with the names of the command line.
#pragma once

#include "engine/core/quantities.h"
#include "engine/deflection/compensation.h"
#include "engine/deflection/feed_adjustment.h"
#include "engine/deflection/identification.h"
#include "engine/deflection/triage.h"
#include "engine/deflection/what_if.h"

namespace lathelier::deflection {

const std::vector<QuantityOf<PassResult>>& quantitiesOf(const PassResult*);
const std::vector<QuantityOf<FinalContour>>& quantitiesOf(const FinalContour*);
const std::vector<QuantityOf<ErrorSummary>>& quantitiesOf(const ErrorSummary*);
const std::vector<QuantityOf<DeflectionResult>>& quantitiesOf(const DeflectionResult*);
const std::vector<QuantityOf<CorrectedNode>>& quantitiesOf(const CorrectedNode*);
const std::vector<QuantityOf<RobustnessRow>>& quantitiesOf(const RobustnessRow*);
const std::vector<QuantityOf<CompensationResult>>& quantitiesOf(const CompensationResult*);
const std::vector<QuantityOf<IdentifiedFactor>>& quantitiesOf(const IdentifiedFactor*);
const std::vector<QuantityOf<ComparedDiameter>>& quantitiesOf(const ComparedDiameter*);
const std::vector<QuantityOf<IdentificationResult>>& quantitiesOf(const IdentificationResult*);
const std::vector<QuantityOf<FeedResult>>& quantitiesOf(const FeedResult*);
const std::vector<QuantityOf<Sensitivity>>& quantitiesOf(const Sensitivity*);
const std::vector<QuantityOf<ErrorBand>>& quantitiesOf(const ErrorBand*);
const std::vector<QuantityOf<CauseFit>>& quantitiesOf(const CauseFit*);
const std::vector<QuantityOf<TriageResult>>& quantitiesOf(const TriageResult*);

}  // namespace lathelier::deflection
