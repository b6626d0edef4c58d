// sample DIR: the sample project with its data, generated with known truth.
#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "engine/core/core_codes.h"
#include "engine/sample/sample_files.h"
#include "engine/sample/series_sample.h"

namespace lathelier {

namespace cli {
namespace {

struct SampleParameters {
    int seed = 1;
    int series = 0;
    int series_points = sample::SeriesModel{}.points;
};

const std::vector<Field<SampleParameters>>& fieldsOf(const SampleParameters*)
{
    static const std::vector<Field<SampleParameters>> all{
        field("seed", &SampleParameters::seed, Range{0, 1000000},
              Label{{"Seed"}, {"Start of the random numbers; the same seed gives the same files."}}),
        field("series", &SampleParameters::series, Range{0, 1000000},
              Label{{"Parts"},
                    {"In place of the project, so many scans of one part whose seat drifts, three of them out of "
                     "tolerance, with the recipe that finds them (0: none; else at least 8)."}}),
        field("series_points", &SampleParameters::series_points, Range{3000, 10000000},
              Label{{"Points"}, {"Of each scan of a series, about."}})};
    return all;
}

std::vector<std::string> written(const std::string& folder, const SampleParameters& parameters,
                                 const Progress& progress)
{
    const auto seed = static_cast<std::uint64_t>(parameters.seed);
    if (parameters.series == 0) return sample::writeSample(folder, seed, progress);
    if (parameters.series < sample::fewestParts)
        throw Error(errors::valueOutOfRange, {{"parameter", std::string("--series")},
                                              {"found", std::int64_t{parameters.series}},
                                              {"expected", LT_TEXT("Engine", "a whole number")},
                                              {"minimum", std::int64_t{sample::fewestParts}},
                                              {"maximum", std::int64_t{1000000}}});
    sample::SeriesModel model;
    model.parts = parameters.series;
    model.points = parameters.series_points;
    model.seed = seed;
    return sample::writeSeries(folder, model, progress);
}

void runSample(const Request& request, io::InputFiles&, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<SampleParameters>(request.parameters);
    const std::vector<std::string> files = written(request.operands.at(0), parameters, progress);
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
