// The table of verbs: a new capability is one line here and one file beside it.
#include "app/cli/verbs.h"

#include "app/cli/task_verb.h"
#include "engine/archive/archive_kind.h"
#include "engine/batch/recipe_kind.h"
#include "engine/cad/step_kind.h"
#include "engine/cad/task/compare_task.h"
#include "engine/cad/task/draw_task.h"
#include "engine/cad/task/recognize_task.h"
#include "engine/cam/task/check_task.h"
#include "engine/cam/task/turn_task.h"
#include "engine/chain/remanufacture_task.h"
#include "engine/core/core_codes.h"
#include "engine/deflection/deflection_task.h"
#include "engine/deflection/toolpath_task.h"
#include "engine/form/task/cylindricity_task.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/io/time_record/time_record_reader.h"
#include "engine/link/link_kind.h"
#include "engine/receptance/spindle/spindle_kind.h"
#include "engine/receptance/task/modes_task.h"
#include "engine/receptance/task/shaft_task.h"
#include "engine/receptance/task/spindle_task.h"
#include "engine/receptance/task/tap_task.h"
#include "engine/series/series_task.h"
#include "engine/shop/shop_file.h"
#include "engine/shop/task/shop_task.h"
#include "engine/stability/task/lobes_task.h"
#include "engine/stability/task/simulate_task.h"
#include "engine/stability/task/speed_task.h"
#include "engine/surface/task/surface_task.h"
#include "engine/trajectory/task/roundness_task.h"
#include "engine/trajectory/task/trajectory_task.h"
#include "engine/verify/verify_task.h"

namespace lathelier::cli {

const std::vector<Verb>& verbs()
{
    static const std::vector<Verb> all = [] {
        std::vector<Verb> table{sampleVerb(),
                                verbOf(cad::compareTask()),
                                verbOf(trajectory::roundnessTask()),
                                verbOf(form::cylindricityTask()),
                                verbOf(trajectory::trajectoryTask()),
                                verbOf(receptance::shaftTask()),
                                verbOf(receptance::spindleTask()),
                                verbOf(receptance::tapTask()),
                                verbOf(receptance::modesTask()),
                                verbOf(stability::lobesTask()),
                                verbOf(stability::speedTask()),
                                verbOf(stability::simulateTask()),
                                verbOf(shop::shopTask()),
                                verbOf(deflection::toolpathTask()),
                                verbOf(cam::turnTask()),
                                verbOf(cam::checkTask()),
                                verbOf(deflection::deflectionTask()),
                                verbOf(chain::remanufactureTask()),
                                verbOf(cad::recognizeTask()),
                                verbOf(cad::drawTask()),
                                verbOf(surface::surfaceTask()),
                                verbOf(series::seriesTask()),
                                archiveVerb(),
                                assistVerb(),
                                verbOf(verify::verifyTask())};
        // inspect knows the files of all others
        io::FileKinds kinds{&io::qdasFiles(),    &io::timeRecordFiles(),      &io::frfFiles(),
                            &io::shaftFiles(),   &receptance::spindleFiles(), &receptance::measurementFiles(),
                            &cad::stepFiles(),   &shop::shopFiles(),          &archive::archiveFiles(),
                            &link::assistFiles()};
        std::vector<const task::Task*> tasks;
        for (const Verb& verb : table) {
            io::unite(kinds, verb.kinds);
            if (verb.task) tasks.push_back(verb.task);
        }
        static const io::FileKind recipes = batch::recipeFiles(tasks);
        kinds.push_back(&recipes);
        table.push_back(batchVerb(tasks));
        table.push_back(queueVerb(tasks));
        table.insert(table.begin() + 1, inspectVerb(kinds));
        return table;
    }();
    return all;
}

void refuseOption(const char* name, const std::string& found, Text expected)
{
    throw Error(errors::valueNotUnderstood, {{"parameter", name}, {"found", found}, {"expected", expected}});
}

std::vector<Option> readingOptions(const Verb& verb)
{
    if (verb.kinds.empty()) return {};
    std::vector<Option> options = optionsOf<io::ImportOptions>();
    for (const io::FileKind* kind : verb.kinds)
        for (const FieldInfo& info : kind->reading) {
            const Value* standard = find(kind->reading_defaults, info.key);
            options.push_back({info, standard ? *standard : Value()});
        }
    return options;
}

}  // namespace lathelier::cli
