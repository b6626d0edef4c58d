#include "engine/stability/stability_verification.h"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/io/frf/frf_noise.h"
#include "engine/io/frf/measured_frf.h"
#include "engine/receptance/usable_lines.h"
#include "engine/stability/lobes.h"
#include "engine/stability/modes.h"
#include "engine/stability/process_damping.h"
#include "engine/stability/simulation/characteristic_root.h"
#include "engine/stability/simulation/simulation.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::stability {
namespace {

using Complex = std::complex<double>;

constexpr double coefficient_N_mm2 = 2000;
constexpr double highestSpeed_rpm = 9000;

std::vector<Mode> oneMode()
{
    return {{223, 0.03, 1e4}};
}
std::vector<Mode> threeModes()
{
    return {{223, 0.03, 1e4}, {410, 0.02, 3e4}, {905, 0.01, 5e4}};
}

template <VerifyKind (*verification)()>
VerifyKind quick(const Progress&)
{
    return verification();
}

}  // namespace

VerifyKind verifyLobeLimits()
{
    VerifyTally tally("lobe_limit", LT_TEXT("Engine", "Limits of the worked example"), unit::mm, 1.1e-4);
    const std::array speeds{2600.0, 2800.0, 2885.0, 3250.0, 3444.0, 4200.0};
    const std::array exact{.5249, .3789, .3098, .6487, .6035, .7003};
    const std::array published{.9325, .3410, .4702, 1.2155, .3090, 1.4660};
    const Frf frf = frfOf(oneMode(), highestSpeed_rpm);
    for (std::size_t i = 0; i < speeds.size(); ++i)
        for (const auto& [relation, known] :
             {std::pair{SpeedRelation::Exact, exact[i]}, {SpeedRelation::Published, published[i]}}) {
            LobeParameters p;
            p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
            p.relation = relation;
            p.speed_rpm = {{speeds[i], speeds[i] + 1}};
            p.points = 2;
            tally.nextSet();
            tally.compare(limitOf(frf, p).depth_mm.front(), known);
        }
    return tally.done();
}

VerifyKind verifyCharacteristicEquation()
{
    VerifyTally tally("characteristic_equation", LT_TEXT("Engine", "Characteristic equation at the lobes"), {}, 1e-10);
    for (const auto& modes : {oneMode(), threeModes()})
        for (const auto& stretch : boundaryOf(frfOf(modes, highestSpeed_rpm), 1, 1)) {
            tally.nextSet();
            for (const BoundaryPoint& point : stretch) {
                const Complex wave = 1.0 - std::polar(1.0, -2 * std::numbers::pi * point.phase_turns);
                tally.take(std::abs(1.0 + receptanceOf(modes, point.frequency_hz) * wave / point.compliance_mm_N));
            }
        }
    return tally.done();
}

VerifyKind verifyDampedLobes()
{
    VerifyTally tally("process_damping", LT_TEXT("Engine", "Characteristic equation with process damping"), {}, 1e-8);
    const double C_N_mm = 400, diameter_mm = 40;
    const double beta = dampingRatioOf(C_N_mm, diameter_mm, coefficient_N_mm2);
    const Boundary boundary = boundaryOf(frfOf(threeModes(), highestSpeed_rpm), 1, 1);
    for (int k = 0; k < 20; k += 3) {
        tally.nextSet();
        for (const auto& stretch : dampedLobeCurve(boundary, k, beta).stretches)
            for (const CurvePoint& point : stretch) {
                const double omega = 2 * std::numbers::pi * point.frequency_hz, turn_s = 60 / point.speed_rpm;
                const double depth_mm = point.depth_N_mm / coefficient_N_mm2;
                const Complex regenerated = point.depth_N_mm * (1.0 - std::polar(1.0, -omega * turn_s));
                const Complex damped(0, omega * dampingOfCut(C_N_mm, depth_mm, diameter_mm, point.speed_rpm));
                const Complex g = receptanceOf(threeModes(), point.frequency_hz);
                // The residual is relative to the larger term, as both grow with the depth.
                tally.take(std::abs(1.0 + g * (regenerated + damped)) /
                           (1 + std::abs(g) * (std::abs(regenerated) + std::abs(damped))));
            }
    }
    return tally.done();
}

VerifyKind verifyRecommendedSpeeds()
{
    VerifyTally tally("recommended_speed", LT_TEXT("Engine", "Speeds of the source papers"), unit::rpm, 1);
    SpeedParameters a;
    a.diameter_mm = 32;
    a.cutting_speed_m_min = 290;
    const SpeedResult paper_a = chooseSpeed(frfOf(oneMode(), highestSpeed_rpm), a);
    for (const auto& [k, speed_rpm] : {std::pair{6, 2617.0}, {5, 3237.0}, {4, 4247.0}}) {
        tally.nextSet();
        double found = std::nan("");
        for (const SpeedCandidate& candidate : paper_a.candidates)
            if (candidate.k == k) found = candidate.speed_rpm;
        tally.compare(found, speed_rpm);
    }
    SpeedParameters b;
    b.diameter_mm = 30;
    b.cutting_speed_m_min = 190;
    tally.nextSet();
    tally.compare(chooseSpeed(frfOf({{369.07 / std::sqrt(1.06), 0.03, 1e4}}, highestSpeed_rpm), b).recommended_rpm,
                  2154);
    return tally.done();
}

VerifyKind verifyGrowth(const Progress& progress)
{
    VerifyTally tally("growth_per_revolution", LT_TEXT("Engine", "Growth of simulated cuts"), {}, 1.5e-3);
    for (const auto& modes : {oneMode(), threeModes()})
        for (const double speed_rpm : {1300.0, 2885.0, 4200.0})
            for (const double depth_mm : {0.2, 0.6}) {
                SimulationParameters p;
                p.speed_rpm = speed_rpm;
                p.depth_mm = depth_mm;
                p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
                p.revolutions = 1;
                tally.nextSet();
                tally.compare(
                    simulate(modes, p, progress.quiet()).growth_per_revolution /
                        growthOfRoots(modes, {coefficient_N_mm2 * depth_mm, 0, 1}, 60 / speed_rpm).per_revolution,
                    1);
            }
    return tally.done();
}

VerifyKind verifyDelayEquation(const Progress& progress)
{
    VerifyTally tally("delay_equation", LT_TEXT("Engine", "Limits against roots of the delay equation"), {}, 2e-3);
    constexpr std::uint64_t machines = 24;
    for (std::uint64_t number = 0; number < machines; ++number) {
        progress.report(static_cast<double>(number) / machines);
        const auto drawn = [&](std::uint64_t stream, double from, double to) {
            return from + (to - from) * randomUniform(44, stream, number);
        };
        std::vector<Mode> modes;
        for (std::uint64_t m = 0; m <= number % 4; ++m)
            modes.push_back({drawn(3 * m, 150, 900), drawn(3 * m + 1, 0.01, 0.06), drawn(3 * m + 2, 5e3, 5e4)});
        const double speed_rpm = drawn(20, 900, 6000);
        LobeParameters p;
        p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
        p.speed_rpm = {{speed_rpm, speed_rpm * (1 + 1e-9)}};
        p.points = 2;
        const double limit_mm = limitOf(frfOf(modes, speed_rpm), p).depth_mm.front();
        // The depth where the rightmost root grows by 1 a revolution, by halving.
        double low_mm = 0.98 * limit_mm, high_mm = 1.02 * limit_mm;
        for (int step = 0; step < 8; ++step) {
            const double depth_mm = (low_mm + high_mm) / 2;
            const double growth =
                growthOfRoots(modes, {coefficient_N_mm2 * depth_mm, 0, 1}, 60 / speed_rpm, progress.quiet())
                    .per_revolution;
            (growth < 1 ? low_mm : high_mm) = depth_mm;
        }
        tally.nextSet();
        tally.compare((low_mm + high_mm) / 2 / limit_mm, 1);
    }
    return tally.done();
}

VerifyKind verifyNoisyLimits()
{
    VerifyTally tally("limit_of_noisy_response", LT_TEXT("Engine", "Limits of impact tests with the sensor's noise"),
                      {}, 0.05);
    const std::vector<Mode> modes{{317, 0.022, 12000}, {900, 0.028, 30000}};
    const double truth = leastRealPart(frfOf(modes, highestSpeed_rpm)).real_mm_N;
    for (const double first_hz : {0.5, 5.0, 20.0})
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            Frf frf;
            frf.quantity = FrfQuantity::Accelerance;
            for (double f = first_hz; f <= 800; f += 0.5) frf.frequency_hz.push_back(f);
            for (std::size_t i = 0; i < frf.frequency_hz.size(); ++i) {
                const double f = frf.frequency_hz[i], noise_mm_s2_N = 25;  // about a hundredth of the resonance
                const Complex noise(randomNormal(seed, 1, i), randomNormal(seed, 2, i));
                frf.value.push_back(-std::pow(2 * std::numbers::pi * f, 2) * receptanceOf(modes, f) +
                                    noise_mm_s2_N * noise);
            }
            frf.noise = io::noiseOf(frf);
            Frf receptance = io::toReceptance(frf);
            Notes notes;
            receptance::takeUsableLines(receptance, {}, {}, notes);
            tally.nextSet();
            tally.compare(leastRealPart(receptance).real_mm_N / truth, 1);
        }
    return tally.done();
}

const VerifyPart& stabilityVerification()
{
    static const VerifyPart part{
        "stability",
        {quick<verifyLobeLimits>, quick<verifyCharacteristicEquation>, quick<verifyDampedLobes>,
         quick<verifyRecommendedSpeeds>, verifyGrowth, verifyDelayEquation, quick<verifyNoisyLimits>},
        {},
        "dynamics"};
    return part;
}

}  // namespace lathelier::stability
