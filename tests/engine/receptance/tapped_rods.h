// Tap tests made without the engine's beams and coupling: rods as Timoshenko finite elements (Przemieniecki, "Theory of
// Matrix Structural Analysis", 1968) on a machine given as a function, the accelerometer as a mass of the model.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "engine/receptance/eirc/spindle_measurements.h"
#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::receptance {

/// Receptance of the chuck face by frequency, signs as in spindle_receptance.h.
using Machine = std::function<ReceptanceMatrix(double frequency_hz)>;

struct MachineMode {
    double frequency_hz, damping, stiffness_N_mm, rotation_rad_mm;  ///< rotation by deflection of its shape
};

/// Springs with loss and modes in series behind them.
inline Machine madeMachine(double radial_N_mm, double tilt_N_mm_rad, double loss, std::vector<MachineMode> modes)
{
    return [=](double frequency_hz) {
        ReceptanceMatrix h = ReceptanceMatrix::Zero();
        h(0, 0) = 1.0 / (radial_N_mm * Complex(1, loss));
        h(1, 1) = 1.0 / (tilt_N_mm_rad * Complex(1, loss));
        for (const MachineMode& mode : modes) {
            const double r = frequency_hz / mode.frequency_hz;
            const Complex g = 1.0 / (mode.stiffness_N_mm * Complex(1 - r * r, 2 * mode.damping * r));
            const Eigen::Vector2d shape(1, mode.rotation_rad_mm);
            h += g * (shape * shape.transpose()).cast<Complex>();
        }
        return h;
    };
}

inline Machine stiffMachine()
{
    return madeMachine(60000, 6e8, 0.04, {{410, 0.04, 90000, -1.0 / 150}, {1120, 0.03, 140000, 1.0 / 60}});
}

inline Machine softMachine()
{
    return madeMachine(15000, 1.974e8, 0.06, {{640, 0.04, 40000, -1.0 / 150}});
}

/// A steel cylinder on a machine; nodes from the chuck (0) to the free end.
class FiniteRod {
public:
    FiniteRod(double length_mm, double diameter_mm, std::vector<double> points_mm)
    {
        points_mm.push_back(length_mm);
        double from = 0;
        place_mm_ = {0};
        std::sort(points_mm.begin(), points_mm.end());
        for (const double to : points_mm) {
            if (!(to > from)) continue;
            const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / 6)));
            for (int i = 1; i <= pieces; ++i) place_mm_.push_back(from + (to - from) * i / pieces);
            from = to;
        }
        for (std::size_t e = 0; e + 1 < place_mm_.size(); ++e) addElement(place_mm_[e + 1] - place_mm_[e], diameter_mm);
    }

    /// w at each node per force at the points, of the rod with a mass at one of them.
    Eigen::MatrixXcd deflections(double frequency_hz, const ReceptanceMatrix& machine,
                                 const std::vector<double>& points_mm, double mass_at_mm, double mass_g) const
    {
        using Block = Eigen::Matrix2cd;
        const double omega = 2 * std::numbers::pi * frequency_hz;
        const std::size_t n = place_mm_.size();
        std::vector<Block> diagonal(n, Block::Zero()), beside(n, Block::Zero());
        for (std::size_t e = 0; e + 1 < n; ++e) {
            const Eigen::Matrix4cd d =
                stiffness_[e].cast<Complex>() * Complex(1, lossFactor) - (omega * omega * mass_[e]).cast<Complex>();
            diagonal[e] += d.topLeftCorner<2, 2>();
            diagonal[e + 1] += d.bottomRightCorner<2, 2>();
            beside[e] = d.topRightCorner<2, 2>();
        }
        diagonal[0] += machine.inverse();
        diagonal[nodeAt(mass_at_mm)](0, 0) -= omega * omega * mass_g * 1e-6;
        const auto columns = static_cast<Eigen::Index>(points_mm.size());
        std::vector<Eigen::MatrixXcd> right(n, Eigen::MatrixXcd::Zero(2, columns));
        for (std::size_t k = 0; k < points_mm.size(); ++k)
            right[nodeAt(points_mm[k])](0, static_cast<Eigen::Index>(k)) = 1;
        for (std::size_t i = 1; i < n; ++i) {  // block elimination
            const Block factor = beside[i - 1].transpose() * diagonal[i - 1].inverse();
            diagonal[i] -= factor * beside[i - 1];
            right[i] -= factor * right[i - 1];
        }
        Eigen::MatrixXcd w(static_cast<Eigen::Index>(n), columns);
        Eigen::MatrixXcd above = Eigen::MatrixXcd::Zero(2, columns);
        for (std::size_t i = n; i-- > 0;) {
            above = (diagonal[i].inverse() * (right[i] - beside[i] * above)).eval();
            w.row(static_cast<Eigen::Index>(i)) = above.row(0);
        }
        return w;
    }

    std::size_t nodeAt(double place_mm) const
    {
        std::size_t best = 0;
        for (std::size_t i = 1; i < place_mm_.size(); ++i)
            if (std::abs(place_mm_[i] - place_mm) < std::abs(place_mm_[best] - place_mm)) best = i;
        return best;
    }

private:
    static constexpr double lossFactor = 0.002;

    void addElement(double l, double diameter_mm)
    {
        constexpr double e = 210000, nu = 0.3, rho = 7850e-12;
        const double area = std::numbers::pi * diameter_mm * diameter_mm / 4;
        const double inertia = std::numbers::pi * std::pow(diameter_mm, 4) / 64;
        const double kappa = 6 * (1 + nu) * (1 + nu) / (7 + 12 * nu + 4 * nu * nu);  // Hutchinson
        const double phi = 12 * e * inertia / (kappa * area * e / (2 * (1 + nu)) * l * l);
        Eigen::Matrix4d k, m, r;
        k << 12, 6 * l, -12, 6 * l, 6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l, -12, -6 * l, 12, -6 * l, 6 * l,
            (2 - phi) * l * l, -6 * l, (4 + phi) * l * l;
        stiffness_.push_back(k * (e * inertia / ((1 + phi) * l * l * l)));
        const double m1 = 13.0 / 35 + 7 * phi / 10 + phi * phi / 3;
        const double m2 = (11.0 / 210 + 11 * phi / 120 + phi * phi / 24) * l;
        const double m3 = 9.0 / 70 + 3 * phi / 10 + phi * phi / 6;
        const double m4 = -(13.0 / 420 + 3 * phi / 40 + phi * phi / 24) * l;
        const double m5 = (1.0 / 105 + phi / 60 + phi * phi / 120) * l * l;
        const double m6 = -(1.0 / 140 + phi / 60 + phi * phi / 120) * l * l;
        m << m1, m2, m3, m4, m2, m5, -m4, m6, m3, -m4, m1, -m2, m4, m6, -m2, m5;
        const double r1 = 6.0 / 5, r2 = (0.1 - phi / 2) * l, r3 = (2.0 / 15 + phi / 6 + phi * phi / 3) * l * l;
        const double r4 = (-1.0 / 30 - phi / 6 + phi * phi / 6) * l * l;
        r << r1, r2, -r1, r2, r2, r3, -r2, r4, -r1, -r2, r1, -r2, r2, r4, -r2, r3;
        const double share = 1 / ((1 + phi) * (1 + phi));
        mass_.push_back(share * (rho * area * l * m + rho * inertia / l * r));
    }

    std::vector<double> place_mm_;
    std::vector<Eigen::Matrix4d> stiffness_, mass_;
};

struct TappedRod {
    double length_mm, diameter_mm;
    std::vector<double> points_mm;  ///< from the chuck
};

inline const std::vector<TappedRod> threeTappedRods{
    {150, 40, {50, 100, 150}}, {200, 40, {60, 130, 200}}, {260, 40, {80, 170, 260}}};

/// Accelerances of all pairs a ≤ b without noise, from 60 Hz on; the sensor's mass at a. Nodes 101, 102…, 201….
inline SpindleMeasurements tapTests(const Machine& machine, const std::vector<TappedRod>& rods, double mass_g = 0,
                                    double to_hz = 1500, double step_hz = 2)
{
    SpindleMeasurements result;
    for (const TappedRod& rod : rods) {
        const FiniteRod model(rod.length_mm, rod.diameter_mm, rod.points_mm);
        MeasuredRod& measured = result.rods.emplace_back();
        measured.shaft.segments = {{rod.length_mm, rod.diameter_mm, rod.diameter_mm, 0, {}, {}}};
        measured.shaft.material = Material{};
        measured.distance_from_chuck_mm = rod.points_mm;
        const auto index = result.rods.size() - 1;
        for (std::size_t a = 0; a < rod.points_mm.size(); ++a)
            measured.node.push_back(static_cast<std::int64_t>(100 * (index + 1) + a + 1));
        for (std::size_t a = 0; a < rod.points_mm.size(); ++a) {
            const std::size_t first = result.frfs.size();
            for (std::size_t b = a; b < rod.points_mm.size(); ++b)
                result.frfs.push_back({index, a, b, {"", FrfQuantity::Accelerance, {}, {}, {}, {}}});
            for (double f = 60; f < to_hz + step_hz / 2; f += step_hz) {
                const Eigen::MatrixXcd w = model.deflections(f, machine(f), rod.points_mm, rod.points_mm[a], mass_g);
                const double omega = 2 * std::numbers::pi * f;
                const auto row = static_cast<Eigen::Index>(model.nodeAt(rod.points_mm[a]));
                for (std::size_t b = a; b < rod.points_mm.size(); ++b) {
                    Frf& frf = result.frfs[first + b - a].frf;
                    frf.frequency_hz.push_back(f);
                    frf.value.push_back(-omega * omega * w(row, static_cast<Eigen::Index>(b)));
                }
            }
        }
    }
    return result;
}

inline Complex deviate(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
{
    return Complex(randomNormal(seed, stream, 2 * index), randomNormal(seed, stream, 2 * index + 1)) / std::sqrt(2.0);
}

/// Errors in proportion to the response.
inline SpindleMeasurements withProportionalNoise(SpindleMeasurements made, double share, std::uint64_t seed)
{
    for (std::size_t k = 0; k < made.frfs.size(); ++k)
        for (std::size_t i = 0; i < made.frfs[k].frf.value.size(); ++i)
            made.frfs[k].frf.value[i] *= 1.0 + share * deviate(seed, k, i);
    return made;
}

/// Noise of the sensor, the same at all lines, `averages` taps: the rms of each response is `ratio` times that of the
/// noise in the mean. With the coherence as it is estimated from that many taps.
inline SpindleMeasurements withSensorNoise(SpindleMeasurements made, double ratio, int averages, std::uint64_t seed)
{
    for (std::size_t k = 0; k < made.frfs.size(); ++k) {
        Frf& frf = made.frfs[k].frf;
        double squares = 0;
        for (const Complex& value : frf.value) squares += std::norm(value);
        const double of_one = std::sqrt(averages * squares / static_cast<double>(frf.value.size())) / ratio;
        frf.coherence.clear();
        for (std::size_t i = 0; i < frf.value.size(); ++i) {
            Complex mean = 0;
            double power = 0;
            for (int tap = 0; tap < averages; ++tap) {
                const Complex one =
                    frf.value[i] + of_one * deviate(seed, 1000 * (k + 1) + static_cast<std::uint64_t>(tap), i);
                mean += one / static_cast<double>(averages);
                power += std::norm(one) / averages;
            }
            frf.coherence.push_back(std::norm(mean) / power);
            frf.value[i] = mean;
        }
    }
    return made;
}

}  // namespace lathelier::receptance
