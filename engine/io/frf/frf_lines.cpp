#include "engine/io/frf/frf_lines.h"

#include <cmath>

#include "engine/core/error.h"
#include "engine/io/frf/frf_codes.h"

namespace lathelier::io {

std::int64_t dropUnusableLines(Frf& frf)
{
    std::size_t kept = 0;
    const std::size_t all = frf.frequency_hz.size();
    for (std::size_t i = 0; i < all; ++i) {
        const bool usable = std::isfinite(frf.frequency_hz[i]) && std::isfinite(frf.value[i].real()) &&
                            std::isfinite(frf.value[i].imag());
        if (!usable) continue;
        frf.frequency_hz[kept] = frf.frequency_hz[i];
        frf.value[kept] = frf.value[i];
        if (!frf.coherence.empty()) frf.coherence[kept] = frf.coherence[i];
        if (!frf.noise.empty()) frf.noise[kept] = frf.noise[i];
        ++kept;
    }
    frf.frequency_hz.resize(kept);
    frf.value.resize(kept);
    if (!frf.coherence.empty()) frf.coherence.resize(kept);
    if (!frf.noise.empty()) frf.noise.resize(kept);
    return static_cast<std::int64_t>(all - kept);
}

void requireAscending(const Frf& frf)
{
    if (frf.frequency_hz.empty())
        throw Error(errors::frfNone, {{"found", LT_TEXT("Engine", "no line with finite values")}});
    for (std::size_t i = 1; i < frf.frequency_hz.size(); ++i)
        if (!(frf.frequency_hz[i] > frf.frequency_hz[i - 1]))
            throw Error(errors::frfNotAscending, {{"index", static_cast<std::int64_t>(i)},
                                                  {"found", frf.frequency_hz[i]},
                                                  {"previous", frf.frequency_hz[i - 1]}});
}

}  // namespace lathelier::io
