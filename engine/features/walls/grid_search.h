// Search for the largest value of a function of one variable on ever finer grids.
#pragma once

namespace lathelier::features {

struct GridMaximum {
    double place = 0, value = 0;
};

/// Each round looks at `steps` places on each side of the best one so far, a fourth as far apart as in the round
/// before. For functions with plateaus and jumps, where derivatives do not help. Cost: rounds·(2 steps + 1) values.
template <class Function>
GridMaximum gridMaximum(const Function& valueAt, double start, double step, int rounds, int steps)
{
    GridMaximum best{start, valueAt(start)};
    for (int round = 0; round < rounds; ++round, step /= 4) {
        const double around = best.place;
        for (int k = -steps; k <= steps; ++k) {
            const double place = around + k * step;
            if (const double value = valueAt(place); value > best.value) best = {place, value};
        }
    }
    return best;
}

}  // namespace lathelier::features
