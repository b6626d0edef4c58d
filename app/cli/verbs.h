// The verbs, one file each.
#pragma once

#include "app/cli/verb.h"

namespace lathelier::cli {

Verb sampleVerb();
Verb inspectVerb();
Verb compareVerb();
Verb roundnessVerb();
Verb cylindricityVerb();
Verb trajectoryVerb();
Verb verifyVerb();

}  // namespace lathelier::cli
