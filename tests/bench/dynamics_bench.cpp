// From a shaft's geometry to stability lobes: exact receptances and coupling, lobes, the recommended speed, the chart;
// beside it a straightforward finite element block solve of the same shaft with Eigen. One core.
#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/receptance/modal/modal_fit.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/report/plot_svg.h"
#include "engine/stability/simulation/response_modes.h"
#include "engine/stability/simulation/response_poles.h"
#include "engine/stability/simulation/simulation.h"
#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_plots.h"

namespace lathelier {
namespace {

using Complex = std::complex<double>;

/// Three segments, from the free end.
Shaft shaft()
{
    Shaft made;
    made.segments = {{98, 30, 30, 0, {}, {}}, {10, 37, 37, 0, {}, {}}, {75, 33.8, 33.8, 0, {}, {}}};
    made.material = Material{};
    return made;
}

constexpr receptance::SpindleSprings springs{14850, 198.3e6, 0.06};

receptance::ShaftHolding onTheMachine()
{
    receptance::ShaftHolding holding;
    holding.spindle = receptance::SpindleReceptance{springs};
    return holding;
}

receptance::ReceptanceParameters usualLines()
{
    receptance::ReceptanceParameters asked;  // 50…5000 Hz by 1 Hz: 4951 lines
    asked.shear = beam::ShearModel::Cowper;
    return asked;
}

Frf response()
{
    return receptanceOf(shaft(), *shaft().material, usualLines(), onTheMachine());
}

stability::LobeParameters usualLobes()
{
    stability::LobeParameters asked;
    asked.cutting_coefficient_N_mm2 = 2000;
    asked.speed_rpm = {{1200, 6000}};
    return asked;
}

void exactCoupled(benchmark::State& state)
{
    const ThreadLimit one(1);
    const Shaft part = shaft();
    for (auto _ : state)
        benchmark::DoNotOptimize(receptanceOf(part, *part.material, usualLines(), onTheMachine()).value.data());
    state.counters["lines"] =
        benchmark::Counter(4951.0 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// Two-node Timoshenko elements of 2.5 mm, assembled once; each line is one sparse solve.
class FiniteElements {
public:
    explicit FiniteElements(const Shaft& part)
    {
        std::vector<Eigen::Triplet<double>> stiff;
        std::vector<Eigen::Triplet<double>> mass;
        int node = 0;
        for (const ShaftSegment& s : part.segments) {
            const int count = static_cast<int>(std::ceil(s.length_mm / 2.5));
            for (int i = 0; i < count; ++i, ++node)
                addElement(s, s.length_mm / count, *part.material, node, stiff, mass);
        }
        size_ = 2 * (node + 1);
        stiffness_.resize(size_, size_);
        mass_.resize(size_, size_);
        stiffness_.setFromTriplets(stiff.begin(), stiff.end());
        mass_.setFromTriplets(mass.begin(), mass.end());
        loss_ = part.material->loss_factor;
    }

    /// w per F at the free end, the chuck face on springs.
    Complex tip(double frequency_hz)
    {
        const double omega = 2 * std::numbers::pi * frequency_hz;
        Eigen::SparseMatrix<Complex> dynamic =
            Complex(1, loss_) * stiffness_.cast<Complex>() - omega * omega * mass_.cast<Complex>();
        const Complex lossy(1, springs.loss_factor);
        dynamic.coeffRef(size_ - 2, size_ - 2) += springs.radial_N_mm * lossy;
        dynamic.coeffRef(size_ - 1, size_ - 1) += springs.tilt_N_mm_rad * lossy;
        if (!analysed_) solver_.analyzePattern(dynamic);
        analysed_ = true;
        solver_.factorize(dynamic);
        Eigen::VectorXcd force = Eigen::VectorXcd::Zero(size_);
        force[0] = 1;
        return solver_.solve(force)[0];
    }

private:
    static void addElement(const ShaftSegment& s, double length, const Material& material, int node,
                           std::vector<Eigen::Triplet<double>>& stiff, std::vector<Eigen::Triplet<double>>& mass)
    {
        const double nu = material.poisson_ratio;
        const double area = std::numbers::pi * std::pow(s.start_diameter_mm, 2) / 4;
        const double inertia = std::numbers::pi * std::pow(s.start_diameter_mm, 4) / 64;
        const double shear = 6 * (1 + nu) / (7 + 6 * nu);
        const double bending = material.elastic_modulus_MPa * inertia;
        const double rigidity = material.elastic_modulus_MPa / (2 * (1 + nu)) * shear * area;
        const double phi = 12 * bending / (rigidity * length * length);
        const double l = length;
        Eigen::Matrix4d k;
        k << 12, 6 * l, -12, 6 * l,                               //
            6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l,  //
            -12, -6 * l, 12, -6 * l,                              //
            6 * l, (2 - phi) * l * l, -6 * l, (4 + phi) * l * l;
        k *= bending / ((1 + phi) * l * l * l);
        const double rho = material.density_kg_m3 * 1e-12;
        Eigen::Matrix4d m;                          // consistent, without the small terms of φ
        m << 156, 22 * l, 54, -13 * l,              //
            22 * l, 4 * l * l, 13 * l, -3 * l * l,  //
            54, 13 * l, 156, -22 * l,               //
            -13 * l, -3 * l * l, -22 * l, 4 * l * l;
        m *= rho * area * l / 420;
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < 4; ++b) {
                stiff.emplace_back(2 * node + a, 2 * node + b, k(a, b));
                mass.emplace_back(2 * node + a, 2 * node + b, m(a, b));
            }
    }

    Eigen::SparseMatrix<double> stiffness_;
    Eigen::SparseMatrix<double> mass_;
    Eigen::SparseLU<Eigen::SparseMatrix<Complex>> solver_;
    int size_ = 0;
    double loss_ = 0;
    bool analysed_ = false;
};

void finiteElementBlocks(benchmark::State& state)
{
    FiniteElements model(shaft());
    constexpr int lines = 100;
    for (auto _ : state)
        for (int i = 0; i < lines; ++i) benchmark::DoNotOptimize(model.tip(50 + 49.5 * i));
    state.counters["lines"] =
        benchmark::Counter(lines * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    const Frf exact = response();
    state.counters["differs_percent"] = 100 * std::abs(model.tip(300) / exact.value[250] - 1.0);
}

/// New damping or stiffness of a mode, coefficient or depth: the response is that of the modes.
void lobesOfModes(benchmark::State& state)
{
    const ThreadLimit one(1);
    for (auto _ : state) {
        const Frf frf = stability::frfOf({{223, 0.03, 1e4}}, 6000);
        benchmark::DoNotOptimize(findLobes(frf, usualLobes()).limit.depth_mm.data());
    }
}

void lobesOfAResponse(benchmark::State& state)
{
    const ThreadLimit one(1);
    const Frf frf = response();
    for (auto _ : state) benchmark::DoNotOptimize(findLobes(frf, usualLobes()).limit.depth_mm.data());
}

void chartFromGeometry(benchmark::State& state)
{
    const ThreadLimit one(1);
    const Shaft part = shaft();
    for (auto _ : state) {
        const Frf frf = receptanceOf(part, *part.material, usualLines(), onTheMachine());
        const stability::LobeResult lobes = findLobes(frf, usualLobes());
        benchmark::DoNotOptimize(lobesPlot(lobes).curves.data());
    }
}

/// The chart on paper.
void chartAsSvg(benchmark::State& state)
{
    const ThreadLimit one(1);
    const stability::LobeResult lobes = findLobes(response(), usualLobes());
    for (auto _ : state) benchmark::DoNotOptimize(report::toSvg(lobesPlot(lobes)).data());
}

void modesOfAResponse(benchmark::State& state)
{
    const ThreadLimit one(1);
    const Frf frf = response();
    for (auto _ : state) benchmark::DoNotOptimize(receptance::fitModes(frf).modes.data());
}

/// A tap test: four modes on 1961 lines, the noise of an accelerometer at a ratio of 300.
Frf tapTest()
{
    std::vector<double> lines;
    for (int f = 40; f <= 2000; ++f) lines.push_back(f);
    Frf frf = receptance::synthesised(
        {{{180, .03, 2e4}, {420, .02, 4e4}, {900, .02, 5e4}, {1500, .015, 9e4}}, {}, {300, 2e-6}}, lines);
    double peak = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) peak = std::max(peak, std::abs(frf.value[i]) * lines[i] * lines[i]);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double sigma = peak / 300 / (lines[i] * lines[i]);
        frf.value[i] += std::complex(sigma * randomNormal(1, 0, i), sigma * randomNormal(1, 1, i));
        frf.noise.push_back(sigma);
    }
    return frf;
}

void modesOfATapTest(benchmark::State& state)
{
    const ThreadLimit one(1);
    const Frf frf = tapTest();
    for (auto _ : state) benchmark::DoNotOptimize(receptance::fitModes(frf).modes.data());
}

void cutInTime(benchmark::State& state)
{
    const ThreadLimit one(1);
    stability::SimulationParameters asked;
    asked.speed_rpm = 2885;
    asked.depth_mm = 0.3;
    asked.cutting_coefficient_N_mm2 = 2000;
    for (auto _ : state) benchmark::DoNotOptimize(simulate({{223, 0.03, 1e4}}, asked).growth_per_revolution);
}

/// From the computed response of a shaft: its poles, the modes through its lines, the cut in time.
void cutOfAShaft(benchmark::State& state)
{
    const ThreadLimit one(1);
    const Frf frf = response();
    stability::SimulationParameters asked;
    asked.speed_rpm = 2885;
    asked.depth_mm = 0.3;
    asked.cutting_coefficient_N_mm2 = 2000;
    for (auto _ : state) {
        const std::vector<stability::Mode> modes = modesThrough(frf, stability::polesOf(frf, {}), {}, 600);
        benchmark::DoNotOptimize(simulate(modes, asked).growth_per_revolution);
    }
}

BENCHMARK(exactCoupled)->Unit(benchmark::kMillisecond);
BENCHMARK(finiteElementBlocks)->Unit(benchmark::kMillisecond);
BENCHMARK(lobesOfModes)->Unit(benchmark::kMillisecond);
BENCHMARK(lobesOfAResponse)->Unit(benchmark::kMillisecond);
BENCHMARK(chartFromGeometry)->Unit(benchmark::kMillisecond);
BENCHMARK(chartAsSvg)->Unit(benchmark::kMillisecond);
BENCHMARK(modesOfAResponse)->Unit(benchmark::kMillisecond);
BENCHMARK(cutOfAShaft)->Unit(benchmark::kMillisecond);
BENCHMARK(modesOfATapTest)->Unit(benchmark::kMillisecond);
BENCHMARK(cutInTime)->Unit(benchmark::kMillisecond);

/// 200 × 200 points of growth per revolution, with so many modes.
void stabilityMap(benchmark::State& state)
{
    std::vector<stability::Mode> modes{{223, 0.03, 10000}, {480, 0.02, 30000}, {905, 0.01, 50000}};
    modes.resize(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(stability::stabilityRaster(modes, {}));
}
BENCHMARK(stabilityMap)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace lathelier

BENCHMARK_MAIN();
