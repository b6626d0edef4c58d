// All sections against the tolerance.
#pragma once

#include "engine/trajectory/trajectory.h"
#include "widgets/core/panel/copy_table.h"

namespace lathelier::longitudinal_panel {

/// Section, z, radius, RONt by the chosen circle, out-of-place, run-out, two-point range, revolutions, verdict;
/// out-of-tolerance sections are marked by symbol and text.
class SectionTable : public CopyTable {
    Q_OBJECT

public:
    explicit SectionTable(QWidget* parent = nullptr);
    void setResult(const trajectory::TrajectoryResult& result);
    void markSection(std::size_t index);

signals:
    void sectionPicked(int section);  ///< section number

private:
    std::vector<int> numbers_;
};

}  // namespace lathelier::longitudinal_panel
