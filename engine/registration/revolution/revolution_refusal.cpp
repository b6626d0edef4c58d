#include "engine/registration/revolution/revolution_refusal.h"

#include "engine/core/core_codes.h"
#include "engine/registration/registration_codes.h"

namespace lathelier::registration {
namespace {

constexpr double notedCoverage_deg = 180;  // below half the circle one side of the part is not seen

/// Value of `reason`, for scripts.
const char* reasonKey(NotTurned reason)
{
    switch (reason) {
        case NotTurned::Flat: return "flat";
        case NotTurned::SeveralParts: return "several_parts";
        case NotTurned::NoSingleAxis: return "no_single_axis";
        case NotTurned::Bent: return "bent";
        case NotTurned::SmallCoverage: return "coverage_too_small";
        case NotTurned::Line: return "line";
        case NotTurned::NotRound: return "not_round";
        case NotTurned::No: return "";
    }
    return "";
}

/// Value of `why`, for people.
Text phraseOf(NotTurned reason)
{
    switch (reason) {
        case NotTurned::Flat: return LT_TEXT("Engine", "it is flat");
        case NotTurned::SeveralParts: return LT_TEXT("Engine", "there are several parts");
        case NotTurned::NoSingleAxis: return LT_TEXT("Engine", "no single axis fits");
        case NotTurned::Bent: return LT_TEXT("Engine", "it is bent");
        case NotTurned::SmallCoverage: return LT_TEXT("Engine", "too little of the circle is there");
        case NotTurned::Line: return LT_TEXT("Engine", "the points lie on a line");
        case NotTurned::NotRound: return LT_TEXT("Engine", "its sections are not round");
        case NotTurned::No: return {};
    }
    return {};
}

}  // namespace

void refuseRevolution(const RevolutionFit& fit, const char* role)
{
    if (fit.not_turned == NotTurned::SmallCoverage)
        throw Error(
            errors::coverageTooSmall,
            {{"role", std::string(role)}, {"coverage_deg", fit.coverage_deg}, {"minimum_deg", leastCoverage_deg}});
    Values values{{"role", std::string(role)},
                  {"reason", std::string(reasonKey(fit.not_turned))},
                  {"why", phraseOf(fit.not_turned)},
                  {"residual_mm", fit.sigma_mm}};
    if (fit.not_turned == NotTurned::Bent) values.emplace_back("bow_mm", fit.bend.size_mm());
    throw Error(errors::notABodyOfRevolution, std::move(values));
}

void remarkRevolution(const RevolutionFit& fit, const char* role, Notes& notes)
{
    if (fit.not_turned == NotTurned::Line)
        throw Error(errors::pointsDegenerate, {{"found", LT_TEXT("Engine", "on a line")}, {"role", std::string(role)}});
    if (fit.bend.isSeen() && (fit.not_turned == NotTurned::No || fit.not_turned == NotTurned::Bent))
        notes.push_back({notes::partIsBent,
                         {{"role", std::string(role)},
                          {"bow_mm", fit.bend.size_mm()},
                          {"bow_uncertainty_mm", fit.bend.uncertainty_mm()}}});
    if (fit.not_turned == NotTurned::No && fit.coverage_deg < notedCoverage_deg)
        notes.push_back({notes::coverageBelowHalf, {{"role", std::string(role)}, {"coverage_deg", fit.coverage_deg}}});
}

void orientAxis(RevolutionFit& fit)
{
    const Eigen::Vector3d direction = fit.axis_T_scan.linear().row(2);
    Eigen::Index dominant = 0;
    direction.cwiseAbs().maxCoeff(&dominant);
    if (direction[dominant] < 0) fit = reversed(fit);
}

}  // namespace lathelier::registration
