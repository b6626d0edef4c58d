#include "engine/receptance/tap/tap_study.h"

#include <algorithm>
#include <cmath>

namespace lathelier::receptance {
namespace {

constexpr std::size_t mostPoints = 200000;  ///< of all records: single pulses are seen when zoomed in
constexpr double betweenRecords = 0.02;     ///< of a record's duration

}  // namespace

TapTrace traceOf(const std::vector<double>& values, double rate_hz, double start_s, std::size_t most)
{
    TapTrace trace;
    const std::size_t step = most < 2 ? values.size() : std::max<std::size_t>(1, 2 * values.size() / most);
    const auto add = [&](std::size_t i) {
        trace.time_s.push_back(start_s + static_cast<double>(i) / rate_hz);
        trace.value.push_back(values[i]);
    };
    for (std::size_t begin = 0; begin < values.size(); begin += std::max<std::size_t>(1, step)) {
        const std::size_t end = std::min(values.size(), begin + step);
        std::size_t low = begin, high = begin;
        for (std::size_t i = begin; i < end; ++i) {
            if (values[i] < values[low]) low = i;
            if (values[i] > values[high]) high = i;
        }
        add(std::min(low, high));
        if (low != high) add(std::max(low, high));
    }
    return trace;
}

TapStudy studyTaps(const std::vector<TapSignals>& records, std::vector<std::string> names, TapResult result)
{
    TapStudy study;
    study.names = std::move(names);
    const std::size_t most = mostPoints / std::max<std::size_t>(1, records.size());
    double end_s = 0;
    for (std::size_t r = 0; r < records.size(); ++r) {
        const TapSignals& record = records[r];
        const double shift_s = r == 0 ? 0 : end_s - record.start_s;
        const double duration_s = static_cast<double>(record.force_N.size()) / record.rate_hz;
        study.shift_s.push_back(shift_s);
        study.force.push_back(traceOf(record.force_N, record.rate_hz, record.start_s + shift_s, most));
        study.motion.push_back(traceOf(record.motion, record.rate_hz, record.start_s + shift_s, most));
        end_s = record.start_s + shift_s + (1 + betweenRecords) * duration_s;
    }
    for (const TapHit& hit : result.hits) {
        const std::vector<double>& motion = records[hit.record].motion;
        double largest = 0;
        for (std::size_t i = hit.first; i < std::min(motion.size(), hit.first + result.samples); ++i)
            largest = std::max(largest, std::abs(motion[i]));
        study.largest.push_back(largest);
    }
    study.result = std::move(result);
    return study;
}

}  // namespace lathelier::receptance
