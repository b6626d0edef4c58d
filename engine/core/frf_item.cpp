#include "engine/core/frf_item.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "engine/core/item_numbers.h"

namespace lathelier {

Values toValues(const Frf& frf)
{
    requireKeepable(frf.frequency_hz.size());
    std::vector<double> real_mm_N, imag_mm_N;
    real_mm_N.reserve(frf.value.size());
    imag_mm_N.reserve(frf.value.size());
    for (const std::complex<double>& value : frf.value) {
        real_mm_N.push_back(value.real());
        imag_mm_N.push_back(value.imag());
    }
    Values values{{"name", frf.name},
                  {"frequency_hz", frf.frequency_hz},
                  {"real_mm_N", std::move(real_mm_N)},
                  {"imag_mm_N", std::move(imag_mm_N)}};
    if (!frf.coherence.empty()) set(values, "coherence", frf.coherence);
    if (!frf.noise.empty()) set(values, "noise_mm_N", frf.noise);
    return values;
}

std::optional<Frf> frfOf(const Values& values)
{
    auto frequency_hz = numbersIn(values, "frequency_hz");
    const auto real_mm_N = numbersIn(values, "real_mm_N");
    const auto imag_mm_N = numbersIn(values, "imag_mm_N");
    if (!frequency_hz || !real_mm_N || !imag_mm_N) return std::nullopt;
    const std::size_t lines = frequency_hz->size();
    if (lines == 0 || real_mm_N->size() != lines || imag_mm_N->size() != lines) return std::nullopt;
    const bool ascends =
        std::adjacent_find(frequency_hz->begin(), frequency_hz->end(), std::greater_equal<>()) == frequency_hz->end();
    if (!ascends || frequency_hz->front() < 0) return std::nullopt;
    Frf frf;
    const Value* const name = find(values, "name");
    if (const auto* said = name ? std::get_if<std::string>(name) : nullptr) frf.name = *said;
    frf.frequency_hz = std::move(*frequency_hz);
    frf.value.reserve(lines);
    for (std::size_t line = 0; line < lines; ++line) frf.value.emplace_back((*real_mm_N)[line], (*imag_mm_N)[line]);
    for (auto [key, kept] : {std::pair{"coherence", &frf.coherence}, std::pair{"noise_mm_N", &frf.noise}}) {
        if (!find(values, key)) continue;
        auto numbers = numbersIn(values, key);
        if (!numbers || numbers->size() != lines) return std::nullopt;
        *kept = std::move(*numbers);
    }
    return frf;
}

}  // namespace lathelier
