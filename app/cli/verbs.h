// The verbs, one file each.
#pragma once

#include "app/cli/verb.h"

namespace lathelier::cli {

Verb sampleVerb();
Verb inspectVerb(const io::FileKinds& kinds);                 ///< accepts all kinds of file of the others
Verb batchVerb(const std::vector<const task::Task*>& tasks);  ///< of which a recipe may be
Verb queueVerb(const std::vector<const task::Task*>& tasks);  ///< likewise
Verb archiveVerb();
Verb assistVerb();

}  // namespace lathelier::cli
