#include "engine/beam/beam_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/beam/beam_codes.h"
#include "engine/beam/uniform_segments.h"
#include "engine/core/core_codes.h"

namespace lathelier::beam {
namespace {

constexpr double tonne_mm3_per_kg_m3 = 1e-12;
constexpr double samePlaceShare = 1e-9;       // share of the length: closer places are merged
constexpr double waveShare = 0.9;             // largest piece length in half wavelengths
constexpr double longestElementShare = 0.01;  // largest element length as share of the shaft length
constexpr double mostParts = 1e5;             // largest number of parts of one piece

void checkNotNegative(const char* parameter, double value, bool may_be_infinite = false)
{
    if (value >= 0 && (may_be_infinite || std::isfinite(value))) return;
    throw Error(errors::valueOutOfRange, {{"parameter", parameter},
                                          {"found", value},
                                          {"expected", LT_TEXT("Engine", "a number")},
                                          {"minimum", 0.0},
                                          {"maximum", HUGE_VAL}});
}

void checkPositive(const char* parameter, double value)
{
    if (value > 0 && std::isfinite(value)) return;
    throw Error(errors::valueOutOfRange, {{"parameter", parameter},
                                          {"found", value},
                                          {"expected", LT_TEXT("Engine", "a number above 0")},
                                          {"minimum", 0.0},
                                          {"maximum", HUGE_VAL}});
}

void checkMaterial(const Material& material)
{
    checkPositive("elastic_modulus_MPa", material.elastic_modulus_MPa);
    checkPositive("density_kg_m3", material.density_kg_m3);
    checkNotNegative("poisson_ratio", material.poisson_ratio);
    checkNotNegative("loss_factor", material.loss_factor);
}

double insideShaft(double z_mm, double length_mm)
{
    const double slack_mm = samePlaceShare * length_mm;
    if (!(z_mm >= -slack_mm && z_mm <= length_mm + slack_mm))
        throw Error(errors::placeOutsideShaft, {{"z_mm", z_mm}, {"length_mm", length_mm}});
    return std::clamp(z_mm, 0.0, length_mm);
}

BeamPiece pieceOf(const UniformSegment& segment, const Material& material, ShearModel shear)
{
    const BeamSection heavy = roundSection(segment.outer_mm, segment.bore_mm);
    const BeamSection stiff = roundSection(segment.stiffness_outer_mm, segment.bore_mm);
    const double density = material.density_kg_m3 * tonne_mm3_per_kg_m3;
    const double shear_modulus_MPa = material.elastic_modulus_MPa / (2 * (1 + material.poisson_ratio));
    const double kappa = shearCoefficient(shear, segment.bore_mm / segment.stiffness_outer_mm, material.poisson_ratio);
    return {segment.length_mm,
            density * heavy.area_mm2,
            density * heavy.second_moment_mm4,
            material.elastic_modulus_MPa * stiff.second_moment_mm4,
            kappa * shear_modulus_MPa * stiff.area_mm2,
            false};
}

bool isSame(const BeamPiece& a, const BeamPiece& b)
{
    return std::abs(a.length_mm - b.length_mm) <= 1e-12 * a.length_mm && a.mass_t_mm == b.mass_t_mm &&
           a.rotary_t_mm == b.rotary_t_mm && a.bending_N_mm2 == b.bending_N_mm2 && a.shear_N == b.shear_N;
}

void appendParts(const BeamPiece& piece, double parts, std::vector<BeamPiece>& result)
{
    const double count = std::clamp(std::ceil(parts), 1.0, mostParts);
    BeamPiece part = piece;
    part.length_mm = piece.length_mm / count;
    for (double i = 0; i < count; ++i) {
        part.same_as_before = !result.empty() && isSame(result.back(), part);
        result.push_back(part);
    }
}

/// Node positions: ends, places and supports, each once.
std::vector<double> cuts(const BeamParameters& parameters, std::span<const double> places_z_mm, double length_mm)
{
    std::vector<double> result{0, length_mm};
    for (const double z : places_z_mm) result.push_back(insideShaft(z, length_mm));
    for (const Support& support : parameters.supports) result.push_back(insideShaft(support.z_mm, length_mm));
    std::sort(result.begin(), result.end());
    return result;
}

std::size_t nodeAt(const std::vector<double>& node_z_mm, double z_mm)
{
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < node_z_mm.size(); ++i)
        if (std::abs(node_z_mm[i] - z_mm) < std::abs(node_z_mm[nearest] - z_mm)) nearest = i;
    return nearest;
}

void addSupport(const Support& support, NodeSupport& node)
{
    checkNotNegative("radial_N_mm", support.radial_N_mm, true);
    checkNotNegative("tilt_N_mm_rad", support.tilt_N_mm_rad, true);
    checkNotNegative("loss_factor", support.loss_factor);
    if (std::isinf(support.radial_N_mm)) {
        node.held.w = true;
    } else {
        node.radial_N_mm += support.radial_N_mm;
        node.radial_loss_N_mm += support.radial_N_mm * support.loss_factor;
    }
    if (std::isinf(support.tilt_N_mm_rad)) {
        node.held.t = true;
    } else {
        node.tilt_N_mm += support.tilt_N_mm_rad;
        node.tilt_loss_N_mm += support.tilt_N_mm_rad * support.loss_factor;
    }
}

}  // namespace

template <>
PieceConstants<double> BeamPiece::constants(double) const
{
    return pieceConstants(length_mm, mass_t_mm, rotary_t_mm, bending_N_mm2, shear_N);
}

template <>
PieceConstants<Complex> BeamPiece::constants(double loss_factor) const
{
    const Complex modulus(1, loss_factor);
    return pieceConstants(length_mm, mass_t_mm, rotary_t_mm, bending_N_mm2 * modulus, shear_N * modulus);
}

template <>
Matrix2<double> NodeSupport::stiffness() const
{
    return {radial_N_mm, 0, 0, tilt_N_mm};
}

template <>
Matrix2<Complex> NodeSupport::stiffness() const
{
    return {{radial_N_mm, radial_loss_N_mm}, {}, {}, {tilt_N_mm, tilt_loss_N_mm}};
}

BeamModel beamModel(const Shaft& shaft, const Material& material, const BeamParameters& parameters,
                    std::span<const double> places_z_mm)
{
    checkMaterial(material);
    checkNotNegative("modal_damping_ratio", parameters.modal_damping_ratio);
    checkPositive("element_length_mm", parameters.element_length_mm);
    BeamModel model;
    model.method = parameters.method;
    model.loss_factor = material.loss_factor + 2 * parameters.modal_damping_ratio;
    const std::vector<UniformSegment> segments =
        uniformSegments(shaft, {parameters.step_correction, parameters.taper_pieces});
    for (const UniformSegment& segment : segments) model.length_mm += segment.length_mm;
    const std::vector<double> cut_mm = cuts(parameters, places_z_mm, model.length_mm);
    const double slack_mm = samePlaceShare * model.length_mm;

    const bool is_element = parameters.method == BeamMethod::FiniteElements;
    const double element_mm = std::min(parameters.element_length_mm, longestElementShare * model.length_mm);
    double begin_mm = 0;
    std::vector<double> node_z_mm{0};
    for (const UniformSegment& segment : segments) {
        const BeamPiece whole = pieceOf(segment, material, parameters.shear);
        const double end_mm = begin_mm + segment.length_mm;
        double from_mm = begin_mm;
        const auto appendTo = [&](double to_mm) {
            BeamPiece piece = whole;
            piece.length_mm = to_mm - from_mm;
            appendParts(piece, is_element ? piece.length_mm / element_mm : 1, model.pieces);
            node_z_mm.resize(model.pieces.size(), HUGE_VAL);  // interior nodes of pieces are not places
            node_z_mm.push_back(to_mm);
            from_mm = to_mm;
        };
        for (const double cut : cut_mm)
            if (cut > from_mm + slack_mm && cut < end_mm - slack_mm) appendTo(cut);
        appendTo(end_mm);
        begin_mm = end_mm;
    }
    model.supports.resize(model.pieces.size() + 1);
    for (const Support& support : parameters.supports)
        addSupport(support, model.supports[nodeAt(node_z_mm, support.z_mm)]);
    for (const double z : places_z_mm) model.places.push_back(nodeAt(node_z_mm, z));
    return model;
}

BeamModel cutForCounting(const BeamModel& model, double frequency_hz)
{
    const double omega = 2 * std::numbers::pi * frequency_hz;
    BeamModel result = model;
    result.pieces.clear();
    result.supports.assign(1, model.supports.front());
    std::vector<std::size_t> node_of{0};
    for (std::size_t i = 0; i < model.pieces.size(); ++i) {
        const BeamPiece& piece = model.pieces[i];
        const PieceConstants<double> constants = piece.constants<double>(0);
        const double apart = std::abs(constants.a_s2_mm2 - constants.b_s2_mm2) * omega * omega;
        const double both = (constants.a_s2_mm2 + constants.b_s2_mm2) * omega * omega;
        // The shorter wave: its wave number squared is -λ₂².
        const double wave = std::sqrt((both + std::hypot(apart, 2 * omega * std::sqrt(constants.c_s2_mm4))) / 2);
        const bool is_exact = model.method == BeamMethod::Exact;
        appendParts(piece, is_exact ? wave * piece.length_mm / (waveShare * std::numbers::pi) : 1, result.pieces);
        result.supports.resize(result.pieces.size());
        result.supports.push_back(model.supports[i + 1]);
        node_of.push_back(result.pieces.size());
    }
    for (std::size_t& place : result.places) place = node_of[place];
    return result;
}

int rigidBodyMotions(const BeamModel& model)
{
    int radial = 0;
    bool tilt = false;
    for (const NodeSupport& node : model.supports) {
        if (node.held.w || node.radial_N_mm > 0) ++radial;
        tilt = tilt || node.held.t || node.tilt_N_mm > 0;
    }
    return 2 - std::min(2, radial + (tilt ? 1 : 0));
}

}  // namespace lathelier::beam
