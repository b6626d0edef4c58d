// queue ACTION ARCHIVE [RECIPE FILES...]: parts that many machines compute, from the archive's database.
#include "engine/queue/queue.h"

#include <nlohmann/json.hpp>

#include "app/cli/recipe_shop.h"
#include "app/cli/verbs.h"
#include "engine/batch/recipe_file.h"
#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/queue/queue_codes.h"
#include "engine/queue/worker.h"

namespace lathelier {

namespace cli {
namespace {

struct QueueOptions {
    std::string person;
    std::string instrument;
    std::string calibrated_on;
    double lost_after_s = 60;
    bool wait = false;
};

const std::vector<Field<QueueOptions>>& fieldsOf(const QueueOptions*)
{
    using Q = QueueOptions;
    static const std::vector<Field<Q>> all{
        field("person", &Q::person, Label{{"Person"}, {"work: who answers for the evaluations."}}),
        field("instrument", &Q::instrument, Label{{"Instrument"}, {"work: that measured the parts."}}),
        field("calibrated_on", &Q::calibrated_on,
              Label{{"Calibrated on"}, {"work: date of the instrument's last calibration."}}),
        field("lost_after_s", &Q::lost_after_s, Range{1, 86400},
              Label{{"Lost after"},
                    {"work: a worker without a sign of life for so long is lost, and its part waits "
                     "again."},
                    {"s"}}),
        field("wait", &Q::wait, Label{{"Wait"}, {"work: wait for further parts until stopped."}})};
    return all;
}

/// Failures as an answer and as the exit code.
void addFailed(std::int64_t failed, Answer& answer)
{
    if (failed > 0) answer.errors.emplace_back(errors::queuePartsFailed, Values{{"failed", failed}});
}

void add(archive::Archive& archive, const batch::Tasks& tasks, const std::vector<std::string>& operands,
         const Progress& progress, Answer& answer)
{
    if (operands.size() < 4) refuseOption("FILES", "", LT_TEXT("Engine", "a recipe, and files, folders or lists"));
    const batch::LoadedRecipe loaded = batch::loadRecipe(operands[2], tasks, progress.quiet());
    batch::requireUnchanged(loaded.recipe, progress.quiet());
    const std::vector<batch::Part> parts =
        batch::partsOf({operands.begin() + 3, operands.end()}, loaded.recipe, progress.quiet());
    const auto queued =
        std::make_shared<const queue::Queued>(queue::enqueue(archive, operands[2], loaded.recipe, parts, progress));
    answer.summary = fill("{queued} parts queued, {there} were there before.\n",
                          {{"queued", queued->queued}, {"there", queued->already_there}});
    answer.json = [queued] {
        Json json{{"recipe_sha256", queued->recipe_sha256},
                  {"queued", queued->queued},
                  {"already_there", queued->already_there},
                  {"failures", Json::array()}};
        for (const batch::Failure& failure : queued->failures) json["failures"].push_back(batch::toJson(failure));
        return json;
    };
    addFailed(static_cast<std::int64_t>(queued->failures.size()), answer);
}

void work(const std::string& location, const batch::Tasks& tasks, const QueueOptions& options, const Progress& progress,
          Answer& answer)
{
    queue::WorkSettings settings;
    settings.location = location;
    settings.worker = queue::nameOfThisWorker();
    settings.attestation = {options.person, options.instrument, options.calibrated_on};
    settings.lost_after_s = options.lost_after_s;
    settings.waits = options.wait;
    const queue::Worked worked = queue::work(settings, tasks, completedByRecipe, progress);
    answer.summary = fill("{computed} parts computed, {refused} refused, {back} put back.\n",
                          {{"computed", worked.computed}, {"refused", worked.refused}, {"back", worked.put_back}});
    answer.json = [worked] {
        return Json{{"computed", worked.computed},
                    {"already_there", worked.already_there},
                    {"refused", worked.refused},
                    {"put_back", worked.put_back}};
    };
    // Also those that were given up after their tries, by this worker or another.
    archive::Archive archive = archive::Archive::open(location, archive::Access::Read, progress.quiet());
    addFailed(queue::stateOf(archive).failed, answer);
}

void show(archive::Archive& archive, Answer& answer)
{
    const auto state = std::make_shared<const queue::QueueState>(queue::stateOf(archive));
    answer.summary = fill(
        "{waiting} waiting, {running} running, {done} done, {failed} failed\n",
        {{"waiting", state->waiting}, {"running", state->running}, {"done", state->done}, {"failed", state->failed}});
    for (const queue::FailedJob& one : state->failures)
        answer.summary.append(one.name).append("  ").append(one.error).append("\n");
    answer.json = [state] { return queue::toJson(*state); };
}

void runQueueVerb(const batch::Tasks& tasks, const Request& request, const Progress& progress, Answer& answer)
{
    const auto options = fromValues<QueueOptions>(request.parameters);
    const std::vector<std::string>& operands = request.operands;
    const std::string& action = operands.at(0);
    const std::string& location = operands.at(1);
    answer.sources = std::make_shared<const task::Sources>();
    if (action == "work") return work(location, tasks, options, progress, answer);
    if (action != "add" && action != "show" && action != "retry")
        refuseOption("ACTION", action, LT_TEXT("Engine", "add, work, show or retry"));
    const bool reads = action == "show";
    archive::Archive archive =
        archive::Archive::open(location, reads ? archive::Access::Read : archive::Access::Write, progress.quiet());
    if (action == "add") return add(archive, tasks, operands, progress, answer);
    if (action == "retry") queue::retryFailed(archive);
    show(archive, answer);
}

}  // namespace

Verb queueVerb(const std::vector<const task::Task*>& tasks)
{
    Verb verb;
    verb.name = "queue";
    verb.summary = "Parts that workers on many machines compute, from the archive's database, into the archive.";
    verb.operands = {
        {"ACTION",
         "add: queue the parts of a recipe; work: compute them until none waits; show: how many "
         "wait; retry: failed ones wait again."},
        {"ARCHIVE", "A database (postgresql://HOST/NAME, service=NAME), or a file for one machine."},
        {"RECIPE FILES", "add: what --save-recipe wrote, and files, folders or lists.", true, false, true}};
    verb.parameters = optionsOf<QueueOptions>();
    verb.run = [tasks](const Request& request, io::InputFiles&, const Progress& progress, Answer& answer) {
        runQueueVerb(tasks, request, progress, answer);
    };
    return verb;
}

}  // namespace cli
}  // namespace lathelier
