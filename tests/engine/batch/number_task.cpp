#include "tests/engine/batch/number_task.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"

namespace lathelier::batch {
namespace numbers {

struct NumberFile {
    double number = 0;
    Notes notes;
};

struct NumberInput {
    using File = NumberFile;
    using Value = double;
    static constexpr const char* item = "number";

    static File read(const io::FileToRead& file)
    {
        std::string_view text = file.bytes;
        while (text.ends_with('\n')) text.remove_suffix(1);
        NumberFile made;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), made.number);
        if (problem != std::errc() || end != text.data() + text.size())
            throw Error(errors::malformed, {{"line", std::int64_t{1}},
                                            {"column", std::int64_t{1}},
                                            {"found", std::string(text)},
                                            {"expected", std::string("a number, \"plain\"")}});
        return made;
    }
    static Value valueOf(const File& file) { return file.number; }
    static io::FileKinds kinds() { return {}; }
    static std::optional<Value> ofItem(const Values&) { return std::nullopt; }
};

struct NumberQuestion {
    double factor = 1;
    double limit = 10;
    int pause_ms = 0;
    std::string name;
};

const std::vector<Field<NumberQuestion>>& fieldsOf(const NumberQuestion*)
{
    static const std::vector<Field<NumberQuestion>> all{
        field("factor", &NumberQuestion::factor, Range{-100, 100}, Label{{"Factor"}, {"Of the number."}}),
        field("limit", &NumberQuestion::limit, Range{-1e6, 1e6}, Label{{"Limit"}, {"Upper limit."}}),
        field("pause_ms", &NumberQuestion::pause_ms, Range{0, 1000}, Label{{"Pause"}, {"Before the answer."}}),
        field("name", &NumberQuestion::name, Label{{"Name"}, {"Of the series."}})};
    return all;
}

}  // namespace numbers

namespace {

using numbers::NumberInput;
using numbers::NumberQuestion;

task::Outcome judge(const project::PanelState& state, const std::vector<std::string>& roles, Stores& stores,
                    task::Sources& sources, const Progress& progress)
{
    ++runsCounted();
    const auto question = fromValues<NumberQuestion>(state.parameters);
    double sum = 0;
    for (const std::string& role : roles)
        for (const std::string& key : project::keysOf(state, role))
            sum += task::take<NumberInput>(state, key, stores, progress, sources).value_or(0);
    std::this_thread::sleep_for(std::chrono::milliseconds(question.pause_ms));
    progress.check();
    const double value = question.factor * sum;
    if (value < 0) throw Error(errors::fileEmpty, {});  // stands for "no answer for this content"
    if (value > 1e6) throw std::runtime_error("too much");
    task::Outcome outcome;
    outcome.notes = sources.notes;
    outcome.verdict = value <= question.limit ? Verdict::Pass : Verdict::Fail;
    outcome.json = [value] { return Json{{"value_mm", value}}; };
    outcome.report = [value](const Language&) {
        report::Document document;
        document.title = fmt::format("value {}", value);
        return document;
    };
    return outcome;
}

task::Task taskOver(const std::string& key, std::vector<task::Input> inputs)
{
    task::Task made;
    made.key = key;
    made.inputs = std::move(inputs);
    task::askFor<NumberQuestion>(made);
    std::vector<std::string> roles;
    for (const task::Input& input : made.inputs) roles.push_back(input.role);
    made.run = [roles](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                       const Progress& progress) { return judge(state, roles, stores, sources, progress); };
    return made;
}

}  // namespace

std::atomic<int>& runsCounted()
{
    static std::atomic<int> runs{0};
    return runs;
}

const task::Task& numberTask()
{
    static const task::Task task = [] {
        task::Input part = task::ofPart(task::input<NumberInput>("part", "", {"Part"}, {"A number."}));
        part.several = true;
        return taskOver("number", {task::optionalInput<NumberInput>("reference", "reference", {"Reference"}, {"One."}),
                                   std::move(part)});
    }();
    return task;
}

const task::Task& pairTask()
{
    static const task::Task task =
        taskOver("pair", {task::ofPart(task::input<NumberInput>("first", "", {"First"}, {"A number."})),
                          task::ofPart(task::input<NumberInput>("second", "", {"Second"}, {"A number."}))});
    return task;
}

Tasks numberTasks()
{
    return {&numberTask(), &pairTask()};
}

void writeText(const std::filesystem::path& path, const std::string& text)
{
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

std::string textOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Recipe numberRecipe(const ScratchFolder& folder, const Values& parameters)
{
    writeText(folder / "reference.txt", "0.5\n");
    project::PanelState state;
    state.parameters = parameters;
    state.inputs["reference"].path = (folder / "reference.txt").string();
    state.inputs["part"].path = "any.txt";
    return recipeOf(numberTask(), state);
}

std::vector<std::string> writeParts(const ScratchFolder& folder, int count)
{
    std::vector<std::string> paths;
    for (int i = 0; i < count; ++i) {
        const std::filesystem::path path = folder / "parts" / fmt::format("p{:03}.txt", i);
        writeText(path, std::to_string(i));
        paths.push_back(path.string());
    }
    return paths;
}

BatchSettings into(const std::filesystem::path& folder, int jobs)
{
    BatchSettings settings;
    settings.folder = folder.string();
    settings.jobs = jobs;
    return settings;
}

}  // namespace lathelier::batch
