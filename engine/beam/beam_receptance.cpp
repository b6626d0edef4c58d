#include "engine/beam/beam_receptance.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/core/units.h"

namespace lathelier::beam {
namespace {

constexpr std::size_t linesAtOnce = 64;

/// Converts rotation dw/dz to dw/dx.
ReceptanceMatrix towardFreeEnd(const Matrix2<Complex>& g)
{
    ReceptanceMatrix result;
    result << g.ww, -g.wt, -g.tw, g.tt;
    return result;
}

}  // namespace

BeamReceptance::BeamReceptance(BeamModel model)
    : model_(std::move(model)),
      isMovable_(rigidBodyMotions(model_) > 0),
      byNode_(model_.places.size()),
      stiffness_(model_.pieces.size()),
      right_(model_.pieces.size() + 1),
      pass_(model_.pieces.size()),
      driving_(model_.places.size())
{
    std::iota(byNode_.begin(), byNode_.end(), std::size_t{0});
    std::stable_sort(byNode_.begin(), byNode_.end(),
                     [this](std::size_t a, std::size_t b) { return model_.places[a] < model_.places[b]; });
    for (const BeamPiece& piece : model_.pieces) constants_.push_back(piece.constants<Complex>(model_.loss_factor));
    for (const NodeSupport& node : model_.supports) support_.push_back(node.stiffness<Complex>());
}

void BeamReceptance::sweep()
{
    if (byNode_.empty()) return;
    const std::size_t first = model_.places[byNode_.front()];
    right_.back() = {};
    for (std::size_t i = model_.pieces.size(); i-- > first;) {
        const PieceStiffness<Complex>& k = stiffness_[i];
        const Matrix2<Complex> pivot = right_[i + 1] + support_[i + 1] + k.right;
        pass_[i] = -(compliance(pivot, model_.supports[i + 1].held) * k.across.transposed());
        right_[i] = k.right.mirrored() + k.across * pass_[i];
    }
    Matrix2<Complex> left{};
    std::size_t node = 0;
    for (std::size_t order = 0; order < byNode_.size(); ++order) {
        for (const std::size_t place_node = model_.places[byNode_[order]]; node < place_node; ++node) {
            const PieceStiffness<Complex>& k = stiffness_[node];
            const Matrix2<Complex> pivot = left + support_[node] + k.right.mirrored();
            left = k.right - k.across.transposed() * compliance(pivot, model_.supports[node].held) * k.across;
        }
        driving_[order] = compliance(left + support_[node] + right_[node], model_.supports[node].held);
    }
}

void BeamReceptance::fillFrom(std::size_t order, std::span<ReceptanceMatrix> result) const
{
    const std::size_t n = places();
    const std::size_t cause = byNode_[order];
    Matrix2<Complex> motion = driving_[order];
    std::size_t node = model_.places[cause];
    for (std::size_t later = order; later < n; ++later) {
        const std::size_t response = byNode_[later];
        for (; node < model_.places[response]; ++node) motion = pass_[node] * motion;
        const ReceptanceMatrix g = towardFreeEnd(motion);
        result[response * n + cause] = g;
        if (response != cause) result[cause * n + response] = g.transpose();
    }
}

void BeamReceptance::at(double frequency_hz, std::span<ReceptanceMatrix> result)
{
    if (frequency_hz == 0 && isMovable_) {
        std::fill(result.begin(), result.end(), ReceptanceMatrix::Constant(Complex(notANumber, notANumber)));
        return;
    }
    compute(frequency_hz, result);
}

void BeamReceptance::at(double frequency_hz, const ReceptanceMatrix& chuck_stiffness,
                        std::span<ReceptanceMatrix> result)
{
    const Matrix2<Complex> own = support_.back();
    const Matrix2<Complex> chuck{chuck_stiffness(0, 0), chuck_stiffness(0, 1), chuck_stiffness(1, 0),
                                 chuck_stiffness(1, 1)};
    support_.back() = own + chuck.mirrored();
    compute(frequency_hz, result);
    support_.back() = own;
}

void BeamReceptance::compute(double frequency_hz, std::span<ReceptanceMatrix> result)
{
    const double omega = 2 * std::numbers::pi * frequency_hz;
    for (std::size_t i = 0; i < constants_.size(); ++i)
        stiffness_[i] =
            model_.pieces[i].same_as_before ? stiffness_[i - 1] : pieceStiffness(model_.method, constants_[i], omega);
    sweep();
    for (std::size_t order = 0; order < byNode_.size(); ++order) fillFrom(order, result);
}

std::vector<ReceptanceMatrix> beamReceptances(const Shaft& shaft, const Material& material,
                                              const BeamParameters& parameters, std::span<const double> places_z_mm,
                                              std::span<const double> frequency_hz, const Progress& progress)
{
    const BeamReceptance prepared(beamModel(shaft, material, parameters, places_z_mm));
    const std::size_t pairs = places_z_mm.size() * places_z_mm.size();
    std::vector<ReceptanceMatrix> values(frequency_hz.size() * pairs);
    parallelFor(frequency_hz.size(), linesAtOnce, progress, [&](std::size_t begin, std::size_t end) {
        BeamReceptance mine = prepared;
        for (std::size_t line = begin; line < end; ++line)
            mine.at(frequency_hz[line], std::span(values).subspan(line * pairs, pairs));
    });
    return values;
}

}  // namespace lathelier::beam
