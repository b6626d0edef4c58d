// sample DIR: the sample project with its data, generated with known truth.
#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "engine/sample/sample_files.h"

namespace lathelier {

namespace cli {
namespace {

struct SampleParameters {
    int seed = 1;
};

const std::vector<Field<SampleParameters>>& fieldsOf(const SampleParameters*)
{
    static const std::vector<Field<SampleParameters>> all{
        field("seed", &SampleParameters::seed, Range{0, 1000000},
              Label{{"Seed"}, {"Start of the random numbers; the same seed gives the same files."}})};
    return all;
}

void runSample(const Request& request, io::InputFiles&, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<SampleParameters>(request.parameters);
    const std::vector<std::string> files =
        sample::writeSample(request.operands.at(0), static_cast<std::uint64_t>(parameters.seed), progress);
    answer.json = [files] { return Json{{"files", files}}; };
    for (const std::string& file : files) answer.summary += file + "\n";
}

}  // namespace

Verb sampleVerb()
{
    return {"sample",
            "Write the sample project and its synthetic data into a folder.",
            {{"DIR", "The folder; made when it is missing.", false, true}},
            optionsOf<SampleParameters>(),
            {},
            {},
            false,
            runSample};
}

}  // namespace cli
}  // namespace lathelier
