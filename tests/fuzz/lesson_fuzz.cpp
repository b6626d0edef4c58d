// Lessons of the training: any bytes are refused as rejected input with a place, or give steps whose checks are read
// again as they are written.
#include <cstdint>

#include "engine/training/lesson.h"
#include "tests/fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    using namespace lathelier::training;
    try {
        const Lesson lesson = readLesson(fuzz::viewOf(data, size), "fuzz");
        fuzz::require(!lesson.title.empty() && !lesson.steps.empty() && lesson.steps.size() <= mostSteps);
        for (const Step& step : lesson.steps) {
            fuzz::require(!step.heading.empty() && step.checks.size() <= mostChecks);
            fuzz::require(step.checks.empty() || !step.task.empty());
            const LessonState nothing;
            isDone(step, nothing);
            for (const Check& check : step.checks) {
                const Lesson again = readLesson("# T\n## S\ntask: t\ncheck: " + written(check), "again");
                fuzz::require(again.steps.front().checks.front() == check);
            }
        }
    } catch (const Error& error) {
        fuzz::require(error.code().kind == ErrorKind::InputRejected && !text(error).empty());
        const Values& values = error.values();
        fuzz::require(find(values, "line") || find(values, "byte") || error.code() == errors::fileEmpty);
    }
    return 0;
}
