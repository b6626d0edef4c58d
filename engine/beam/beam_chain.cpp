#include "engine/beam/beam_chain.h"

namespace lathelier::beam {
namespace {

/// Number of negative eigenvalues of a symmetric 2×2 matrix without the rigidly held motions.
int negativeOf(const Matrix2<double>& a, Held held)
{
    if (held.w && held.t) return 0;
    if (held.w) return a.tt < 0 ? 1 : 0;
    if (held.t) return a.ww < 0 ? 1 : 0;
    // By elimination: the sign of the first pivot, then that of the second.
    const double second = a.tt - a.wt * a.tw / a.ww;
    return (a.ww < 0 ? 1 : 0) + (second < 0 ? 1 : 0);
}

NodeVector times(const Matrix2<double>& a, const NodeVector& v)
{
    return {a.ww * v.w + a.wt * v.t, a.tw * v.w + a.tt * v.t};
}

NodeVector vectorDifference(const NodeVector& a, const NodeVector& b)
{
    return {a.w - b.w, a.t - b.t};
}

}  // namespace

BeamChain::BeamChain(BeamModel model) : model_(std::move(model)), stiffness_(model_.pieces.size())
{
    for (const BeamPiece& piece : model_.pieces) constants_.push_back(piece.constants<double>(0));
}

void BeamChain::computeStiffness(double omega_rad_s)
{
    for (std::size_t i = 0; i < constants_.size(); ++i)
        stiffness_[i] = model_.pieces[i].same_as_before ? stiffness_[i - 1]
                                                        : pieceStiffness(model_.method, constants_[i], omega_rad_s);
}

Matrix2<double> BeamChain::pivotOf(std::size_t node, const Matrix2<double>& left) const
{
    const Matrix2<double> own = left + model_.supports[node].stiffness<double>();
    return node < stiffness_.size() ? own + stiffness_[node].right.mirrored() : own;
}

int BeamChain::negativeEigenvalues(double omega_rad_s)
{
    computeStiffness(omega_rad_s);
    int count = 0;
    Matrix2<double> left{};
    for (std::size_t node = 0; node <= stiffness_.size(); ++node) {
        const Matrix2<double> pivot = pivotOf(node, left);
        const Held held = model_.supports[node].held;
        count += negativeOf(pivot, held);
        if (node == stiffness_.size()) break;
        const PieceStiffness<double>& k = stiffness_[node];
        left = k.right - k.across.transposed() * compliance(pivot, held) * k.across;
    }
    return count;
}

std::vector<NodeVector> BeamChain::solve(double omega_rad_s, std::vector<NodeVector> load)
{
    computeStiffness(omega_rad_s);
    const std::size_t last = stiffness_.size();
    std::vector<Matrix2<double>> inverse(last + 1);
    Matrix2<double> left{};
    for (std::size_t node = 0;; ++node) {
        inverse[node] = compliance(pivotOf(node, left), model_.supports[node].held);
        if (node == last) break;
        const PieceStiffness<double>& k = stiffness_[node];
        const Matrix2<double> back = k.across.transposed() * inverse[node];
        left = k.right - back * k.across;
        load[node + 1] = vectorDifference(load[node + 1], times(back, load[node]));
    }
    for (std::size_t node = last + 1; node-- > 0;) {
        if (node < last) load[node] = vectorDifference(load[node], times(stiffness_[node].across, load[node + 1]));
        load[node] = times(inverse[node], load[node]);
    }
    return load;
}

}  // namespace lathelier::beam
