#include "engine/features/outline/end_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/features/outline/outline_limits.h"

namespace lathelier::features {
namespace {

constexpr std::size_t rowSectors = 48;  // of the circle: hits of a row are counted in each

/// A hit near the end. Heights grow toward the end, from its estimated place.
struct RowHit {
    double row_mm = 0;  ///< height of its row where the row meets the part's axis
    std::size_t sector = 0;
};

struct ScannedRow {
    double row_mm = 0;                      ///< as RowHit::row_mm
    std::array<double, rowSectors> hits{};  ///< number of hits
    double all = 0;                         ///< hits of all sectors
};

/// Radii within which a point is a hit, along the height.
class HitBand {
public:
    HitBand(const Model& model, double guess_mm, double sign, double from_mm, double to_mm)
        : from_mm_(from_mm), sign_(sign)
    {
        constexpr double step = endRowLimits.band_step_mm;
        const auto count = static_cast<std::size_t>((to_mm - from_mm) / step) + 2;
        const double reach = std::max(model.spot_mm, endRowLimits.assumed_spot_mm) / 2 + endRowLimits.band_reach_mm;
        const auto around = static_cast<std::size_t>(reach / step) + 1;
        const double margin = endRowLimits.band_sigmas * model.sigma_mm + endRowLimits.band_margin_mm;
        std::vector<std::pair<double, double>> radii(count);
        for (std::size_t i = 0; i < count; ++i)
            radii[i] = radiiAt(model, guess_mm + sign * (from_mm + step * static_cast<double>(i)));
        for (std::size_t i = 0; i < count; ++i) {
            std::pair<double, double> wide = radii[i];
            for (std::size_t k = i - std::min(i, around); k < std::min(count, i + around + 1); ++k)
                wide = {std::min(wide.first, radii[k].first), std::max(wide.second, radii[k].second)};
            band_.emplace_back(wide.first - margin, wide.second + margin);
        }
    }

    bool holds(double height_mm, double r_mm) const
    {
        const double place = (height_mm - from_mm_) / endRowLimits.band_step_mm + 0.5;
        if (!(place >= 0 && place < static_cast<double>(band_.size()))) return false;
        const auto& [low, high] = band_[static_cast<std::size_t>(place)];
        return r_mm > low && r_mm < high;
    }

private:
    std::pair<double, double> radiiAt(const Model& model, double z_mm) const
    {
        const Run* run = &model.runs.front();
        for (const Run& one : model.runs)
            if (one.nodes_mm.front() <= z_mm) run = &one;
        const double at = std::clamp(z_mm, run->nodes_mm.front(), run->nodes_mm.back());
        const Element& first = run->elements.front();
        // The chamfer of a thread may be no row of its own.
        if (first.rough) return {std::min(first.root_mm, first.level_mm) - endRowLimits.below_root_mm, first.level_mm};
        const double r = radiusAt_mm(*run, at);
        // A round falls to the radius of its centre where it is upright, wherever the end was estimated.
        const Element& last = sign_ < 0 ? model.runs.front().elements.front() : model.runs.back().elements.back();
        const bool is_round = last.arc && last.convex;
        const double upright = last.centre_z_mm + sign_ * last.radius_mm();
        if (is_round && (z_mm - upright) * sign_ > -endRowLimits.upright_reach_mm)
            return {std::min(r, std::max(0.0, last.centre_r_mm)), r};
        return {r, r};
    }

    double from_mm_, sign_;
    std::vector<std::pair<double, double>> band_;  ///< every endRowLimits.band_step_mm
};

/// The rows near an end, and the likelihood of its place.
class RowsAtEnd {
public:
    RowsAtEnd(const MeridianCloud& cloud, const Model& model, bool start, const registration::ScannerAxis& scanner)
        : sign_(start ? -1 : 1),
          guess_mm_(start ? model.planes.front().z_mm : model.planes.back().z_mm),
          radius_mm_(start ? startRadius_mm(model.runs.front()) : endRadius_mm(model.runs.back())),
          tilt_(sign_ * scanner.direction.head<2>() / scanner.direction.z())
    {
        const double length = model.planes.back().z_mm - model.planes.front().z_mm;
        depth_mm_ = std::min(endRowLimits.depth_mm, endRowLimits.depth_share * length);
        swing_mm_ = tilt_.norm() * radius_mm_;
        collect(cloud, HitBand(model, guess_mm_, sign_, -depth_mm_, endRowLimits.beyond_mm));
    }

    std::optional<EndPlace> find()
    {
        if (!makeRows() || !countWhole()) return std::nullopt;
        addEmptyRows();
        return decide();
    }

private:
    void collect(const MeridianCloud& cloud, const HitBand& band)
    {
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
            const double height = (static_cast<double>(cloud.z_mm[i]) - guess_mm_) * sign_;
            const double r = static_cast<double>(cloud.r_mm[i]);
            if (height < -depth_mm_ || height > endRowLimits.beyond_mm || !band.holds(height, r)) continue;
            const double turn = static_cast<double>(cloud.turn[i]);
            const auto sector = static_cast<std::size_t>(turn * static_cast<double>(rowSectors));
            hits_.push_back({height + r * leanAt(turn), std::min(rowSectors - 1, sector)});
        }
        std::sort(hits_.begin(), hits_.end(), [](const RowHit& a, const RowHit& b) { return a.row_mm < b.row_mm; });
    }

    /// By how much a row that is at the axis at some height lies lower, per radius.
    double leanAt(double turn) const
    {
        const double angle = 2 * std::numbers::pi * turn;
        return tilt_.x() * std::cos(angle) + tilt_.y() * std::sin(angle);
    }

    /// Rows are sharp: between them there is nothing.
    bool makeRows()
    {
        double last = -std::numeric_limits<double>::infinity();
        for (const RowHit& hit : hits_) {
            if (hit.row_mm - last > endRowLimits.row_gap_mm) rows_.emplace_back();
            last = hit.row_mm;
            ScannedRow& row = rows_.back();
            row.row_mm += hit.row_mm;
            row.hits[hit.sector] += 1;
            row.all += 1;
        }
        std::vector<double> sizes;
        for (ScannedRow& row : rows_) {
            row.row_mm /= row.all;
            sizes.push_back(row.all);
        }
        if (sizes.size() < endRowLimits.least_rows) return false;
        const double least =
            std::max(endRowLimits.least_row_hits, endRowLimits.least_row_share * upperMedianInPlace(sizes));
        std::erase_if(rows_, [&](const ScannedRow& row) { return row.all < least; });
        // The first rows are cut by the depth, obliquely.
        const double whole_from = -depth_mm_ + swing_mm_;
        std::erase_if(rows_, [&](const ScannedRow& row) { return row.row_mm < whole_from; });
        return rows_.size() >= endRowLimits.least_rows;
    }

    /// Hits of a whole row in each sector, from the rows that lie well before the end.
    bool countWhole()
    {
        const double reach = swing_mm_ + endRowLimits.before_mm;
        const double last = std::min(0.0, lastHalf_mm()) - reach;
        while (first_ < rows_.size() && rows_[first_].row_mm < last) ++first_;
        if (first_ < endRowLimits.least_whole_rows || first_ == rows_.size()) return false;
        const std::size_t from = first_ - std::min(first_, endRowLimits.most_whole_rows);
        std::vector<double> usual;
        for (std::size_t s = 0; s < rowSectors; ++s) {
            std::vector<double> counts;
            for (std::size_t k = from; k < first_; ++k) counts.push_back(rows_[k].hits[s]);
            whole_[s] = upperMedianInPlace(counts);
            usual.push_back(whole_[s]);
        }
        const double least = endRowLimits.whole_share * quantileInPlace(usual, endRowLimits.usual_share);
        double hits = 0, rays = 0;
        std::size_t sectors = 0;
        for (std::size_t s = 0; s < rowSectors; ++s) {
            if (whole_[s] < 1 || whole_[s] < least || !reachesEnd(s)) whole_[s] = 0;
            if (whole_[s] > 0) ++sectors;
            for (std::size_t k = from; k < first_; ++k) {
                hits += std::min(rows_[k].hits[s], whole_[s]);
                rays += whole_[s];
            }
        }
        if (sectors < endRowLimits.least_sectors) return false;
        hit_ = std::clamp(hits / rays, endRowLimits.least_hit_share, endRowLimits.hit_probability);
        std::vector<double> gaps;
        for (std::size_t k = from; k + 1 < first_; ++k) gaps.push_back(rows_[k + 1].row_mm - rows_[k].row_mm);
        pitch_mm_ = lowerQuantileInPlace(gaps, endRowLimits.pitch_quantile);
        return pitch_mm_ > 0;
    }

    /// Height of the last row with half of the usual hits.
    double lastHalf_mm() const
    {
        std::vector<double> sizes;
        for (const ScannedRow& row : rows_) sizes.push_back(row.all);
        const double half = upperMedianInPlace(sizes) / 2;
        for (std::size_t k = rows_.size(); k-- > 0;)
            if (rows_[k].all >= half) return rows_[k].row_mm;
        return 0;
    }

    /// A sector whose hits end before the others' has a mark, or lies in a shadow.
    bool reachesEnd(std::size_t sector) const
    {
        const double common = lastHalf_mm() - endRowLimits.reach_mm - 2 * swing_mm_;
        for (std::size_t k = rows_.size(); k-- > first_;)
            if (rows_[k].hits[sector] >= whole_[sector] / 2) return rows_[k].row_mm >= common;
        return false;
    }

    /// Beyond the last row: those that the part's end would have let pass.
    void addEmptyRows()
    {
        const double last = rows_.back().row_mm;
        const double reach = 2 * swing_mm_ + endRowLimits.widths_mm.back() + 2 * pitch_mm_;
        const std::size_t used = rows_.size();
        for (double row = last + pitch_mm_; row <= last + reach && rows_.size() < used + endRowLimits.most_empty_rows;
             row += pitch_mm_) {
            rows_.emplace_back();
            rows_.back().row_mm = row;
        }
    }

    /// ln of the probability of the hits in one cell, of `whole_[s]` rays that each hit with probability p; a share of
    /// all cells is anything.
    double logCell(std::size_t k, std::size_t s, double p) const
    {
        const double n = whole_[s], c = std::min(rows_[k].hits[s], n);
        const double log_binomial = logWays_[k][s] + c * std::log(p) + (n - c) * std::log(1 - p);
        constexpr double odd = endRowLimits.odd_cells;
        return std::log((1 - odd) * std::exp(log_binomial) + odd / (n + 1));
    }

    /// ln of the binomial coefficients of all cells. By a table: std::lgamma() writes a global variable.
    void countWays()
    {
        const auto most = static_cast<std::size_t>(*std::max_element(whole_.begin(), whole_.end()));
        std::vector<double> log_factorial{0};
        log_factorial.reserve(most + 1);
        logWays_.reserve(rows_.size());
        for (std::size_t n = 1; n <= most; ++n)
            log_factorial.push_back(log_factorial.back() + std::log(static_cast<double>(n)));
        for (const ScannedRow& row : rows_) {
            std::array<double, rowSectors>& ways = logWays_.emplace_back();
            for (std::size_t s = 0; s < rowSectors; ++s) {
                const auto n = static_cast<std::size_t>(whole_[s]),
                           c = static_cast<std::size_t>(std::min(row.hits[s], whole_[s]));
                ways[s] = log_factorial[n] - log_factorial[c] - log_factorial[n - c];
            }
        }
    }

    double logRow(std::size_t k, double p) const
    {
        double sum = 0;
        for (std::size_t s = 0; s < rowSectors; ++s)
            if (whole_[s] > 0) sum += logCell(k, s, p);
        return sum;
    }

    /// ln likelihood of the rows from the first that may be incomplete on, when the part ends at a height.
    double logPart(double height, double width) const
    {
        double sum = 0;
        for (std::size_t k = first_; k < rows_.size(); ++k) {
            const double off = rows_[k].row_mm - height, reach = swing_mm_ + width / 2;
            if (off < -reach) {
                sum += allHit_[k];
            } else if (off > reach) {
                sum += noneHit_[k];
            } else {
                for (std::size_t s = 0; s < rowSectors; ++s) {
                    if (whole_[s] == 0) continue;
                    const double seen = 0.5 - (off - rise_mm_[s]) / width;
                    sum += logCell(k, s, std::clamp(seen * hit_, 1 - endRowLimits.hit_probability, hit_));
                }
            }
        }
        return sum;
    }

    EndPlace decide()
    {
        countWays();
        for (std::size_t s = 0; s < rowSectors; ++s)
            rise_mm_[s] = radius_mm_ * leanAt((static_cast<double>(s) + 0.5) / static_cast<double>(rowSectors));
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            allHit_.push_back(k < first_ ? 0 : logRow(k, hit_));
            noneHit_.push_back(k < first_ ? 0 : logRow(k, 1 - endRowLimits.hit_probability));
        }
        // The data end: after each row in turn; the distance to the next is the share of such places.
        std::vector<double> data;
        double before = 0;
        for (std::size_t k = first_; k + 1 < rows_.size(); ++k) {
            before += allHit_[k];
            double sum = before + std::log(rows_[k + 1].row_mm - rows_[k].row_mm);
            for (std::size_t after = k + 1; after < rows_.size(); ++after) sum += noneHit_[after];
            data.push_back(sum);
        }
        constexpr double step = endRowLimits.place_step_mm;
        const double from = rows_[first_].row_mm, to = rows_.back().row_mm - endRowLimits.widths_mm.back() / 2;
        std::vector<double> part;
        for (double height = from; height <= std::max(from, to); height += step) {
            std::vector<double> of_width;
            for (const double width : endRowLimits.widths_mm) of_width.push_back(logPart(height, width));
            part.push_back(logSum(of_width) - std::log(static_cast<double>(of_width.size())));
        }
        EndPlace found;
        found.log_ratio = logSum(part) + std::log(step) - logSum(data);
        summarise(part, from, found);
        return found;
    }

    /// Mean, standard deviation and interval of the posterior of the part's end.
    void summarise(const std::vector<double>& part, double from, EndPlace& found) const
    {
        constexpr double step = endRowLimits.place_step_mm;
        const double all = logSum(part);
        double mean = 0, squares = 0, sum = 0, low = from, high = from;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const double weight = std::exp(part[i] - all), height = from + step * static_cast<double>(i);
            mean += weight * height;
            squares += weight * height * height;
            if (sum < endRowLimits.tail_share) low = height - step / 2;
            if (sum < 1 - endRowLimits.tail_share) high = height + step / 2;
            sum += weight;
        }
        found.place.z_mm = guess_mm_ + sign_ * mean;
        found.place.sigma_mm =
            std::sqrt(std::max(0.0, squares - mean * mean) + step * step / 12 + endRowLimits.place_floor_mm2);
        const double a = guess_mm_ + sign_ * low, b = guess_mm_ + sign_ * high;
        found.from_mm = std::min(a, b);
        found.to_mm = std::max(a, b);
    }

    static double logSum(const std::vector<double>& logs)
    {
        const double most = *std::max_element(logs.begin(), logs.end());
        double sum = 0;
        for (const double one : logs) sum += std::exp(one - most);
        return most + std::log(sum);
    }

    double sign_, guess_mm_, radius_mm_;
    Eigen::Vector2d tilt_;                      ///< of the rows: height per radius
    double depth_mm_ = 0, swing_mm_ = 0;        ///< half of the height that a row covers around the end
    std::vector<RowHit> hits_;                  ///< in order of height
    std::vector<ScannedRow> rows_;              ///< likewise; those beyond the last hits are empty
    std::size_t first_ = 0;                     ///< first row that may be incomplete
    std::array<double, rowSectors> whole_{};    ///< hits of a whole row; 0: the sector does not count
    std::array<double, rowSectors> rise_mm_{};  ///< of the middle of a sector over the row at the axis
    std::vector<std::array<double, rowSectors>>
        logWays_;                           ///< of each row: ln of the binomial coefficients of its cells
    double hit_ = 1, pitch_mm_ = 0;         ///< share of the rays of a whole row that hit
    std::vector<double> allHit_, noneHit_;  ///< ln likelihood of each row when all its rays hit, or none
};

}  // namespace

std::optional<EndPlace> endInRows(const MeridianCloud& cloud, const Model& model, bool start,
                                  const registration::ScannerAxis& scanner)
{
    return RowsAtEnd(cloud, model, start, scanner).find();
}

}  // namespace lathelier::features
