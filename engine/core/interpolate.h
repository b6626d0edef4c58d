// Piecewise linear functions given by their values at ascending places.
#pragma once

#include <algorithm>
#include <cstddef>

namespace lathelier {

/// Linear between the places; before the first and beyond the last its value. Precondition: there is a place, and as
/// many values.
template <class Places, class Values>
auto linearAt(const Places& places, const Values& values, double at)
{
    const auto after = std::upper_bound(places.begin(), places.end(), at);
    if (after == places.begin()) return values.front();
    if (after == places.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - places.begin());
    const double share = (at - places[i - 1]) / (places[i] - places[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace lathelier
