// The table of verbs: a new capability is one line here and one file beside it.
#include "app/cli/verbs.h"

namespace lathelier::cli {

const std::vector<Verb>& verbs()
{
    static const std::vector<Verb> all{sampleVerb(),       inspectVerb(),    compareVerb(), roundnessVerb(),
                                       cylindricityVerb(), trajectoryVerb(), verifyVerb()};
    return all;
}

}  // namespace lathelier::cli
