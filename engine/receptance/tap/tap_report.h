// An impact test as answer, tables, JSON and report.
#pragma once

#include "engine/core/json.h"
#include "engine/core/quantities.h"
#include "engine/receptance/tap/tap_study.h"
#include "engine/report/document.h"

namespace lathelier::receptance {

/// A hit as tables and JSON show it.
struct ShownHit {
    std::int64_t number = 0;  ///< from 1
    std::string record;       ///< name of its record
    TapHit hit;
};
std::vector<ShownHit> shownHits(const TapStudy& study);
const std::vector<QuantityOf<ShownHit>>& quantitiesOf(const ShownHit*);

/// `hits`, `receptance` {`frequency_hz`, `real_mm_N`, `imag_mm_N`, `coherence` (null for one hit)}, `averages`,
/// `estimator`, `window`, `window_decay_1_s`, `quantity`, block, lines and usable range.
Json toJson(const TapStudy& study);

report::Answer answer(const TapStudy& study, const Language& language = {});
report::Table hitsTable(const TapStudy& study);
report::Document tapReport(const TapStudy& study, const Notes& notes, const Language& language = {});

}  // namespace lathelier::receptance
