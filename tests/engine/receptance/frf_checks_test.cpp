// Mislabelled responses.
#include "engine/receptance/frf_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/receptance/modal/modal_model.h"
#include "engine/receptance/receptance_codes.h"

namespace lathelier::receptance {
namespace {

/// Values of `quantity` under the label `label`, of a structure held or free.
io::MeasuredFrf labelled(FrfQuantity quantity, FrfQuantity label, bool held, double noise = .02)
{
    std::vector<double> lines;
    for (double f = 5; f <= 1000; f += 1) lines.push_back(f);
    ModalModel model{{{400, .02, 1e4}}, {}, {}};
    if (!held) model.residuals.lower_mm_Ns2 = 2e3;
    Frf frf = synthesised(model, lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::complex<double> iw(0, 2 * std::numbers::pi * lines[i]);
        if (quantity == FrfQuantity::Mobility) frf.value[i] *= iw;
        if (quantity == FrfQuantity::Accelerance) frf.value[i] *= iw * iw;
        frf.value[i] *= 1 + noise * randomNormal(1, 0, i);
    }
    frf.quantity = label;
    io::MeasuredFrf measured;
    measured.frf = std::move(frf);
    return measured;
}

constexpr FrfQuantity receptance = FrfQuantity::Receptance, mobility = FrfQuantity::Mobility,
                      accelerance = FrfQuantity::Accelerance;

bool isDoubted(FrfQuantity quantity, FrfQuantity label, bool held)
{
    return contains(checkResponse(labelled(quantity, label, held), "file"), notes::frfSlopeContradictsLabel);
}

}  // namespace

TEST(FrfChecks, TheSlopeBelowTheFirstModeTellsTheQuantity)
{
    EXPECT_NEAR(lowSlope(labelled(receptance, receptance, true).frf)->power, 0, .15);
    EXPECT_NEAR(lowSlope(labelled(mobility, mobility, true).frf)->power, 1, .15);
    EXPECT_NEAR(lowSlope(labelled(accelerance, accelerance, true).frf)->power, 2, .15);
    EXPECT_NEAR(lowSlope(labelled(receptance, receptance, false).frf)->power, -2, .15);
}

TEST(FrfChecks, RightLabelsAreBelieved)
{
    for (const FrfQuantity quantity : {receptance, mobility, accelerance})
        for (const bool held : {true, false})
            EXPECT_TRUE(checkResponse(labelled(quantity, quantity, held), "f").empty());
}

TEST(FrfChecks, WrongLabelsAreDoubted)
{
    EXPECT_TRUE(isDoubted(accelerance, receptance, true));
    EXPECT_TRUE(isDoubted(mobility, receptance, true));
    EXPECT_TRUE(isDoubted(mobility, receptance, false));
    EXPECT_TRUE(isDoubted(accelerance, mobility, true));
    EXPECT_TRUE(isDoubted(receptance, mobility, true));
    EXPECT_TRUE(isDoubted(mobility, accelerance, true));
    const Notes notes = checkResponse(labelled(accelerance, receptance, true), "file");
    EXPECT_EQ(std::get<Text>(*find(notes.front().values, "found")), LT_TEXT("Engine", "an accelerance"));
}

TEST(FrfChecks, NothingIsSaidWhereNothingCanBeTold)
{
    // A free accelerance has the slope of a receptance that is held; noise hides the slope; no line is low enough.
    EXPECT_FALSE(isDoubted(accelerance, receptance, false));
    EXPECT_FALSE(lowSlope(labelled(accelerance, receptance, true, 2).frf));
    io::MeasuredFrf high = labelled(accelerance, receptance, true);
    high.frf.frequency_hz.erase(high.frf.frequency_hz.begin(), high.frf.frequency_hz.begin() + 200);
    high.frf.value.erase(high.frf.value.begin(), high.frf.value.begin() + 200);
    EXPECT_FALSE(lowSlope(high.frf));
    EXPECT_FALSE(lowSlope(Frf{}));
}

TEST(FrfChecks, ATurnedAndAConjugatedResponseAreToldApart)
{
    const io::MeasuredFrf right = labelled(receptance, receptance, true);
    io::MeasuredFrf turned = right, conjugated = right;
    for (auto& value : turned.frf.value) value = -value;
    for (auto& value : conjugated.frf.value) value = std::conj(value);
    EXPECT_TRUE(contains(checkResponse(turned, "file"), notes::frfTurned));
    EXPECT_FALSE(contains(checkResponse(turned, "file"), notes::frfConjugated));
    EXPECT_TRUE(contains(checkResponse(conjugated, "file"), notes::frfConjugated));
    EXPECT_FALSE(contains(checkResponse(conjugated, "file"), notes::frfTurned));
    // Between two places either sign is right, but not either sense of time.
    for (io::MeasuredFrf* one : {&turned, &conjugated}) one->response_node = 1, one->reference_node = 2;
    EXPECT_TRUE(checkResponse(turned, "file").empty());
    EXPECT_TRUE(contains(checkResponse(conjugated, "file"), notes::frfConjugated));
    // The reader has said it of a stated driving point.
    conjugated.reference_node = 1;
    conjugated.response_direction = conjugated.reference_direction = 1;
    EXPECT_TRUE(checkResponse(conjugated, "file").empty());
}

TEST(FrfChecks, PowerGivenAwayIsSaidWhereNoCircleTells)
{
    io::MeasuredFrf measured = labelled(receptance, receptance, true);
    std::erase_if(measured.frf.value, [](const auto& value) { return std::abs(value) > 1.2e-4; });
    measured.frf.frequency_hz.resize(measured.frf.value.size());  // below and above the resonance only
    for (auto& value : measured.frf.value) value = std::conj(value);
    EXPECT_TRUE(contains(checkResponse(measured, "file"), notes::frfPowerGivenAway));
    measured.response_node = 1;
    measured.reference_node = 2;
    EXPECT_FALSE(contains(checkResponse(measured, "file"), notes::frfPowerGivenAway));
}

}  // namespace lathelier::receptance
