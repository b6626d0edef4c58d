// The verbs, one file each.
#pragma once

#include "app/cli/verb.h"

namespace lathelier::cli {

Verb sampleVerb();
Verb inspectVerb(const io::FileKinds& kinds);  ///< accepts all kinds of file of the others
Verb roundnessVerb();
Verb trajectoryVerb();
Verb remanufactureVerb();
Verb verifyVerb();

}  // namespace lathelier::cli
