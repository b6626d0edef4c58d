// Bores of a recognised part.
#pragma once

#include "engine/features/outline/dimensions.h"
#include "engine/features/outline/outline.h"
#include "engine/features/recognition.h"
#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::features {

/// Bores: stretches of the inner outline that reach an end of the part. One that reaches both is cut at its last
/// hidden stretch; without one it is a through bore.
void addSeenBores(const Outline& inner, double zero_mm, double length_mm, const registration::RevolutionFit& fit,
                  const AddedUncertainty& added, Recognition& result);

}  // namespace lathelier::features
