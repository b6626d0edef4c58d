// The verbs, one file each.
#pragma once

#include "app/cli/verb.h"

namespace lathelier::cli {

Verb sampleVerb();
Verb archiveVerb();
Verb inspectVerb(const io::FileKinds& kinds);  ///< accepts all kinds of file of the others

}  // namespace lathelier::cli
