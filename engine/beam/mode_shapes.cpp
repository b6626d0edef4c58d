// Mode shapes by inverse iteration on the chain at its natural frequencies.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/beam/beam_chain.h"
#include "engine/beam/natural_frequencies.h"

namespace lathelier::beam {
namespace {

constexpr double besideTheRoot = 1e-10;  // relative offset: the stiffness at the root itself is singular
constexpr double oneFrequency = 1e-6;    // relative distance below which modes are orthogonalised
constexpr double longestPieceShare = 0.02;
constexpr int iterations = 4;

using Motion = std::vector<NodeVector>;

/// Chain subdivided finely enough to find the largest deflection.
BeamModel fine(const BeamModel& model, double most_hz)
{
    BeamModel result = model;
    result.pieces.clear();
    result.supports.assign(1, model.supports.front());
    std::vector<std::size_t> node_of{0};
    for (std::size_t i = 0; i < model.pieces.size(); ++i) {
        BeamPiece part = model.pieces[i];
        const bool is_exact = model.method == BeamMethod::Exact;
        const double parts = is_exact ? std::ceil(part.length_mm / (longestPieceShare * model.length_mm)) : 1;
        const auto count = static_cast<std::size_t>(std::max(1.0, parts));
        part.length_mm /= static_cast<double>(count);
        result.pieces.insert(result.pieces.end(), count, part);
        result.supports.resize(result.pieces.size());
        result.supports.push_back(model.supports[i + 1]);
        node_of.push_back(result.pieces.size());
    }
    for (std::size_t& place : result.places) place = node_of[place];
    return cutForCounting(result, most_hz);
}

class ShapeFinder {
public:
    ShapeFinder(const BeamModel& model, double most_hz) : chain_(fine(model, most_hz))
    {
        const std::vector<BeamPiece>& pieces = chain_.model().pieces;
        mass_.resize(pieces.size() + 1);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const double half = pieces[i].length_mm / 2;
            for (const std::size_t node : {i, i + 1}) {
                mass_[node].w += pieces[i].mass_t_mm * half;
                mass_[node].t += pieces[i].rotary_t_mm * half;
            }
        }
    }

    ModeShape shapeAt(double frequency_hz)
    {
        Motion motion(mass_.size());
        for (std::size_t i = 0; i < motion.size(); ++i)  // asymmetric start vector, so that it contains every mode
            motion[i].w = std::cos(1.7 * static_cast<double>(i) + 0.3 * static_cast<double>(found_.size()));
        const double omega = 2 * std::numbers::pi * frequency_hz * (1 - besideTheRoot);
        for (int i = 0; i < iterations; ++i) {
            makeOrthogonal(motion, frequency_hz);
            for (std::size_t node = 0; node < motion.size(); ++node) {
                motion[node].w *= mass_[node].w;
                motion[node].t *= mass_[node].t;
            }
            motion = chain_.solve(omega, std::move(motion));
            normalise(motion);
        }
        makeOrthogonal(motion, frequency_hz);
        normalise(motion);
        found_.push_back({frequency_hz, motion});
        ModeShape shape{frequency_hz, {}, {}};
        for (const std::size_t node : chain_.model().places) {
            shape.deflection.push_back(motion[node].w);
            shape.rotation_mm.push_back(-motion[node].t);
        }
        return shape;
    }

private:
    struct Found {
        double frequency_hz;
        Motion motion;
    };

    double inner(const Motion& a, const Motion& b) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += mass_[i].w * a[i].w * b[i].w + mass_[i].t * a[i].t * b[i].t;
        return sum;
    }

    void makeOrthogonal(Motion& motion, double frequency_hz) const
    {
        for (const Found& other : found_) {
            if (std::abs(other.frequency_hz - frequency_hz) > oneFrequency * frequency_hz) continue;
            const double share = inner(motion, other.motion) / inner(other.motion, other.motion);
            for (std::size_t i = 0; i < motion.size(); ++i) {
                motion[i].w -= share * other.motion[i].w;
                motion[i].t -= share * other.motion[i].t;
            }
        }
    }

    static void normalise(Motion& motion)
    {
        double largest = 0;
        for (const NodeVector& node : motion)
            if (std::abs(node.w) > std::abs(largest) * (1 + 1e-9)) largest = node.w;  // of ties the first
        if (largest == 0) return;
        for (NodeVector& node : motion) node = {node.w / largest, node.t / largest};
    }

    BeamChain chain_;
    Motion mass_;  // lumped mass by node
    std::vector<Found> found_;
};

}  // namespace

std::vector<ModeShape> modeShapes(const BeamModel& model, double most_hz, const Progress& progress)
{
    const std::vector<double> frequencies_hz = naturalFrequencies(model, most_hz, progress.part(0, 0.8));
    std::vector<ModeShape> shapes;
    if (frequencies_hz.empty()) return shapes;
    ShapeFinder finder(model, most_hz);
    for (const double frequency : frequencies_hz) {
        progress.check();
        shapes.push_back(finder.shapeAt(frequency));
    }
    progress.report(1);
    return shapes;
}

}  // namespace lathelier::beam
