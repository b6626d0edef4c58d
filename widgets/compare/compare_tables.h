// The numbers of a comparison as tables that can be copied.
#pragma once

#include "engine/cad/task/compare_places.h"
#include "widgets/core/panel/copy_table.h"

namespace lathelier::compare_panel {

/// Every quantity of the result: name, value, unit.
class StatisticsTable : public CopyTable {
    Q_OBJECT

public:
    explicit StatisticsTable(QWidget* parent = nullptr);
    void setOutcome(const cad::CompareOutcome& outcome);
};

/// Mean deviation of each zone along the axis; out-of-tolerance zones are marked by symbol and text.
class ZoneTable : public CopyTable {
    Q_OBJECT

public:
    explicit ZoneTable(QWidget* parent = nullptr);
    void setResult(const registration::CompareResult& result);
    void markZ(std::optional<double> z_mm);  ///< selects the zone at or next to z

signals:
    void zonePicked(double z_mm);

private:
    std::vector<registration::Zone> zones_;
};

/// The sizes of the part against its drawing; out-of-tolerance sizes are marked by symbol and text.
class SizeTable : public CopyTable {
    Q_OBJECT

public:
    explicit SizeTable(QWidget* parent = nullptr);
    void setSizes(const features::ShaftComparison& sizes);
    void markZ(std::optional<double> z_mm);  ///< selects the first size of the row at z

signals:
    void sizePicked(double z_mm);

private:
    std::vector<Interval> places_;  ///< z interval by row
};

}  // namespace lathelier::compare_panel
