#include "engine/surface/lattice_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lathelier::surface {
namespace {

constexpr int mostMultiple = 4;                // of the vibration
constexpr double mostOrder = 2.6;              // of the feed: lines of higher order are weak…
constexpr double mostKnownOrder = 5.6;         // …unless they exceed the noise
constexpr double leastFittedSignificance = 5;  // S of a line that is fitted
constexpr int patch = 2;                       // bins used to either side of a line
constexpr double leastAlong_bins = 3;

/// Fourier transform of a Hann window centred at zero; real.
double windowTransform(double offset, int count)
{
    const auto kernel = [count](double d) {
        const double bottom = std::sin(std::numbers::pi * d);
        return std::abs(bottom) < 1e-12 ? double(count) : std::sin(std::numbers::pi * d * count) / bottom;
    };
    return 0.5 * kernel(offset) + 0.25 * (kernel(offset - 1.0 / count) + kernel(offset + 1.0 / count));
}

/// Indices of a line.
struct Indices {
    int l, j;
};

/// The problem with its samples of the spectrum.
class Fit {
public:
    Fit(const WindowedPicture& picture, Vector feed, Vector chatter, const Significance* noise)
        : picture_(picture), bins_{double(picture.columns()), double(picture.rows())}
    {
        const Vector along = (1 / length(feed)) * feed;
        const double least = leastAlong_bins * std::hypot(along.x / bins_.x, along.y / bins_.y);
        const double most = (noise ? mostKnownOrder : mostOrder) * length(feed);
        for (int l = -mostMultiple; l <= mostMultiple; ++l)
            for (int j = -12; j <= 12; ++j) {
                const Vector line = double(l) * chatter + double(j) * feed;
                const double place = dot(line, along);
                if (place < least || place > most || std::abs(line.x) > 0.48 || std::abs(line.y) > 0.48) continue;
                if (place > mostOrder * length(feed) && noise->at(line, NoiseLevel::Medians) < leastFittedSignificance)
                    continue;
                lines_.push_back({l, j});
                sample(line);
            }
        data_.resize(static_cast<Eigen::Index>(values_.size()), 2);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            data_(static_cast<Eigen::Index>(i), 0) = values_[i].real();
            data_(static_cast<Eigen::Index>(i), 1) = values_[i].imag();
        }
    }

    bool isDetermined() const { return values_.size() > 3 * lines_.size() && !lines_.empty(); }

    /// Residuals of the best amplitudes, real parts before imaginary ones. `p`: K_f and K_c in bins.
    Eigen::VectorXd residuals(const Eigen::Vector4d& p) const
    {
        const Vector feed{p[0] / bins_.x, p[1] / bins_.y}, chatter{p[2] / bins_.x, p[3] / bins_.y};
        const auto count = static_cast<Eigen::Index>(places_.size());
        Eigen::MatrixXd model(count, static_cast<Eigen::Index>(lines_.size()));
        for (Eigen::Index k = 0; k < model.cols(); ++k) {
            const Indices& index = lines_[static_cast<std::size_t>(k)];
            const Vector line = double(index.l) * chatter + double(index.j) * feed;
            for (Eigen::Index i = 0; i < count; ++i) {
                const Vector offset = places_[static_cast<std::size_t>(i)] - line;
                // the transform of the window is negligible beyond a few bins
                model(i, k) =
                    std::abs(offset.x) * bins_.x > 4.5 || std::abs(offset.y) * bins_.y > 4.5
                        ? 0
                        : windowTransform(offset.x, picture_.columns()) * windowTransform(offset.y, picture_.rows());
            }
        }
        Eigen::MatrixXd normal = model.transpose() * model;
        normal.diagonal() *= 1 + 1e-3;  // regularisation: coincident lines share the amplitude
        const Eigen::MatrixXd left = data_ - model * normal.ldlt().solve(model.transpose() * data_);
        return Eigen::Map<const Eigen::VectorXd>(left.data(), left.size());
    }

    double power() const { return data_.squaredNorm(); }

private:
    /// Samples the bins around a line, each once, with phases relative to the middle of the picture.
    void sample(Vector line)
    {
        const int column = static_cast<int>(std::lround(line.x * bins_.x));
        const int row = static_cast<int>(std::lround(line.y * bins_.y));
        for (int x = column - patch; x <= column + patch; ++x) {
            std::vector<double> fy;
            for (int y = row - patch; y <= row + patch; ++y) {
                const Vector place{x / bins_.x, y / bins_.y};
                const bool known = std::any_of(places_.begin(), places_.end(), [&](Vector other) {
                    return std::abs(other.x - place.x) * bins_.x < 0.5 && std::abs(other.y - place.y) * bins_.y < 0.5;
                });
                if (known) continue;
                places_.push_back(place);
                fy.push_back(place.y);
            }
            const auto found = picture_.at(x / bins_.x, fy);
            for (std::size_t i = 0; i < found.size(); ++i) {
                const double phase =
                    2 * std::numbers::pi * (x / bins_.x * 0.5 * (bins_.x - 1) + fy[i] * 0.5 * (bins_.y - 1));
                values_.push_back(found[i] * std::polar(1.0, phase));
            }
        }
    }

    const WindowedPicture& picture_;
    Vector bins_;
    std::vector<Indices> lines_;
    std::vector<Vector> places_;
    std::vector<std::complex<double>> values_;
    Eigen::MatrixXd data_;
};

/// `r`: the residuals at p.
Eigen::MatrixXd slopes(const Fit& fit, const Eigen::Vector4d& p, const Eigen::VectorXd& r)
{
    constexpr double step = 1e-4;  // bins
    Eigen::MatrixXd result(r.size(), 4);
    for (int k = 0; k < 4; ++k) {
        Eigen::Vector4d next = p;
        next[k] += step;
        result.col(k) = (fit.residuals(next) - r) / step;
    }
    return result;
}

}  // namespace

std::optional<LatticeVectors> fittedLattice(const WindowedPicture& picture, Vector feed, Vector chatter, int iterations,
                                            const Significance* noise)
{
    const Fit fit(picture, feed, chatter, noise);
    if (!fit.isDetermined()) return std::nullopt;
    const double columns = picture.columns(), rows = picture.rows();
    const Eigen::Vector4d start(feed.x * columns, feed.y * rows, chatter.x * columns, chatter.y * rows);
    Eigen::Vector4d p = start;
    Eigen::VectorXd r = fit.residuals(p);
    double damping = 1e-2;
    constexpr double converged_bins = 5e-4;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        const Eigen::MatrixXd jacobian = slopes(fit, p, r);
        const Eigen::Matrix4d curvature = jacobian.transpose() * jacobian;
        const Eigen::Vector4d gradient = jacobian.transpose() * r;
        bool better = false;
        Eigen::Vector4d step = Eigen::Vector4d::Zero();
        for (int attempt = 0; attempt < 6 && !better; ++attempt) {
            Eigen::Matrix4d damped = curvature;
            damped.diagonal() *= 1 + damping;
            step = -damped.ldlt().solve(gradient);
            const Eigen::VectorXd next = fit.residuals(p + step);
            better = next.squaredNorm() < r.squaredNorm();
            if (better) {
                p += step;
                r = next;
                damping = std::max(1e-6, damping / 5);
            } else {
                damping *= 8;
            }
        }
        if (!better || step.norm() < converged_bins) break;
    }
    if ((p - start).cwiseAbs().maxCoeff() > 1.0 || !p.allFinite()) return std::nullopt;
    return LatticeVectors{{p[0] / columns, p[1] / rows}, {p[2] / columns, p[3] / rows}, fit.power() - r.squaredNorm()};
}

}  // namespace lathelier::surface
