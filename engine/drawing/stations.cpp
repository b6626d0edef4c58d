#include "engine/drawing/stations.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::drawing {
namespace {

class Finder {
public:
    explicit Finder(const std::vector<ContourRow>& rows) : rows_(rows), wanted_(rows.size(), false)
    {
        if (rows.empty()) return;
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) wanted_[i] = isShoulder(i);
        for (std::size_t i = 0; i < rows.size();) i = afterRun(i);
        wanted_.back() = true;
    }

    std::vector<Station> stations() const
    {
        std::vector<Station> found;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            const ContourRow& row = rows_[i];
            if (!wanted_[i] || std::abs(row.end_z_mm - rows_.front().start_z_mm) < same_mm) continue;
            double radius = row.end_diameter_mm / 2;
            if (i + 1 < rows_.size()) radius = std::max(radius, rows_[i + 1].start_diameter_mm / 2);
            if (!found.empty() && std::abs(found.back().z_mm - row.end_z_mm) < same_mm)
                found.back().radius_mm = std::max(found.back().radius_mm, radius);
            else
                found.push_back({row.end_z_mm, radius, i});
        }
        return found;
    }

private:
    /// Between row i and the next one.
    bool isShoulder(std::size_t i) const
    {
        const ContourRow &a = rows_[i], &b = rows_[i + 1];
        if (!a.isMinor() && !b.isMinor()) return true;
        if (std::abs(a.end_diameter_mm - b.start_diameter_mm) < same_mm) return false;
        if (a.kind == RowKind::Groove || b.kind == RowKind::Groove) return false;
        return a.kind != RowKind::Undercut || b.kind != RowKind::Undercut;
    }

    /// Assigns a place to a run of minor rows that begins at `first`, if it has none; returns the row after it.
    std::size_t afterRun(std::size_t first)
    {
        std::size_t last = first;
        while (last < rows_.size() && rows_[last].isMinor()) ++last;
        if (last == first) return first + 1;
        if (first == 0 || last == rows_.size()) return last;
        bool has_place = false;
        for (std::size_t i = first - 1; i < last; ++i) has_place = has_place || wanted_[i];
        if (has_place) return last;
        const bool larger_after = rows_[last].start_diameter_mm > rows_[first - 1].end_diameter_mm + same_mm;
        wanted_[larger_after ? last - 1 : first - 1] = true;
        return last;
    }

    const std::vector<ContourRow>& rows_;
    std::vector<bool> wanted_;  // the end of each row
};

}  // namespace

std::vector<Station> stationsOf(const std::vector<ContourRow>& rows)
{
    return Finder(rows).stations();
}

}  // namespace lathelier::drawing
