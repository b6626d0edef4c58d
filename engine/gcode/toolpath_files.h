// A toolpath as JSON, table and report.
#pragma once

#include <functional>
#include <string_view>

#include "engine/core/json.h"
#include "engine/core/quantities.h"
#include "engine/gcode/toolpath.h"
#include "engine/report/document.h"

namespace lathelier::gcode {

const std::vector<QuantityOf<Diagnostic>>& quantitiesOf(const Diagnostic*);

/// line, column, severity, code, text, block.
Rows diagnosticRows(const std::vector<Diagnostic>& diagnostics);

/// `dialect`, `words`, `words_understood`, `diagnostics`, and `moves` where no diagnostic is an error.
Json toJson(const Toolpath& path);

/// Columns line,kind,x_mm,z_mm,centre_x_mm,centre_z_mm,clockwise,feed_mm_rev,feed_mm_min,speed_rpm,cutting_speed_m_min,
/// speed_limit_rpm,dwell_s,tool; missing values are empty. Decimal point in every locale; passed to `append` in chunks.
void writeMoves(const Toolpath& path, const std::function<void(std::string_view)>& append);

inline constexpr std::size_t mostTabled = 200;  ///< largest number of rows in a printed table

/// Line, Column, Severity, Remark, Block.
report::Table diagnosticTable(const std::vector<Diagnostic>& diagnostics, const Language& language = {});

/// Counts and diagnostics.
report::Section toolpathSummary(const Toolpath& path, const Language& language = {});
report::Document toolpathReport(const Toolpath& path, const Language& language = {});

}  // namespace lathelier::gcode
