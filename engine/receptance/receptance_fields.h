// Field descriptions of parameters shared by several capabilities of this room.
#pragma once

#include "engine/beam/beam_section.h"
#include "engine/beam/piece_stiffness.h"
#include "engine/core/fields.h"

namespace lathelier::receptance {

template <class P>
Field<P> shearField(beam::ShearModel P::*member)
{
    return field("shear", member,
                 {{"hutchinson", LT_TEXT("Engine", "Hutchinson")}, {"cowper", LT_TEXT("Engine", "Cowper")}},
                 Label{LT_TEXT("Engine", "Shear coefficient"),
                       LT_TEXT("Engine", "Hutchinson's agrees with finite elements in three dimensions to 0.03 %."),
                       {},
                       true});
}

template <class P>
Field<P> methodField(beam::BeamMethod P::*member)
{
    return field("method", member,
                 {{"exact", LT_TEXT("Engine", "Exact")}, {"fe", LT_TEXT("Engine", "Finite elements")}},
                 Label{LT_TEXT("Engine", "Method"),
                       LT_TEXT("Engine", "Timoshenko's beam in closed form, or finite elements as a check."),
                       {},
                       true});
}

}  // namespace lathelier::receptance
