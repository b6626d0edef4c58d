// A series as a chart, tables, an answer and a report.
#pragma once

#include <string>

#include "engine/core/json.h"
#include "engine/report/document.h"
#include "engine/series/series_task.h"

namespace lathelier::series {

/// "zones › seat › mean" of "zones.seat.mean_mm"; "answer" by the name of its task.
std::string shownName(const archive::ArchivedCharacteristic& characteristic, const Language& language = {});

/// The unit as a text of the program; empty: none.
Text unitOf(const archive::ArchivedCharacteristic& characteristic);

/// Values with U over their number, limits, control limits, mean; those out of tolerance apart.
report::Plot seriesPlot(const SeriesOutcome& outcome, const Language& language = {});

/// Number, time, part, value, U, limits, verdict.
report::Table valuesTable(const SeriesOutcome& outcome, const Language& language = {});

/// The characteristics to choose from: key, unit, time of the latest value.
report::Table characteristicsTable(const SeriesOutcome& outcome, const Language& language = {});

/// Who evaluated which file when with what, and all characteristics of the part in detail.
report::QuantityTable partTable(const SeriesOutcome& outcome);
report::Table partCharacteristics(const SeriesOutcome& outcome, const Language& language = {});

report::QuantityTable statisticsTable(const SeriesOutcome& outcome);
report::Answer answer(const SeriesOutcome& outcome, const Language& language = {});
report::Document seriesReport(const SeriesOutcome& outcome, const Language& language = {});
Json toJson(const SeriesOutcome& outcome);

}  // namespace lathelier::series
