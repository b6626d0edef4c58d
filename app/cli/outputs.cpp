#include "app/cli/outputs.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>

#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"
#include "engine/io/opened_files.h"
#include "engine/io/probe/probe_reader.h"

namespace lathelier::cli {
namespace {

namespace fs = std::filesystem;

/// Identity of a file: links and different spellings of its path are equal.
struct NamedFile {
    std::string option;  ///< that names it; empty: an operand
    std::string path;    ///< path as typed
    std::optional<std::pair<dev_t, ino_t>> identity;
    fs::path place;  ///< empty: no place in the file system
};

std::optional<std::pair<dev_t, ino_t>> identityOf(const struct stat& status)
{
    if (S_ISCHR(status.st_mode)) return std::nullopt;  // a terminal or /dev/null has no content to lose
    return std::pair(status.st_dev, status.st_ino);
}

NamedFile named(const std::string& option, const std::string& path)
{
    NamedFile file{option, path, std::nullopt, {}};
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) {
        file.identity = identityOf(status);
        return file;
    }
    std::error_code problem;  // a file that is still to be made has a place only
    file.place = fs::weakly_canonical(fs::absolute(path, problem), problem);
    return file;
}

bool isSame(const NamedFile& a, const NamedFile& b)
{
    if (a.identity || b.identity) return a.identity == b.identity;
    return !a.place.empty() && a.place == b.place;
}

/// The files behind the words that options take: a word may be anything, but if it is a file or folder, it is read.
void addFilesOf(const Option& option, const Values& parameters, std::vector<NamedFile>& inputs)
{
    if (option.info.kind != FieldInfo::Kind::Word || option.is_output) return;
    const Value* value = find(parameters, option.info.key);
    const auto* word = value ? std::get_if<std::string>(value) : nullptr;
    if (!word || word->empty()) return;
    std::error_code problem;
    if (fs::is_regular_file(*word, problem)) inputs.push_back(named({}, *word));
    if (!fs::is_directory(*word, problem)) return;
    for (fs::directory_iterator entry(*word, problem), end; !problem && entry != end; entry.increment(problem))
        inputs.push_back(named({}, entry->path().string()));
}

std::vector<NamedFile> inputsOf(const Invocation& invocation)
{
    std::vector<NamedFile> inputs;
    const std::vector<Operand>& operands = invocation.verb->operands;
    const bool areOutputs = !operands.empty() && operands.front().is_output;
    if (!areOutputs)
        for (const std::string& path : invocation.request.operands) {
            inputs.push_back(named({}, path));
            for (const std::string& partner : io::recordPartners(path)) inputs.push_back(named({}, partner));
        }
    for (const Option& option : invocation.verb->parameters) addFilesOf(option, invocation.request.parameters, inputs);
    return inputs;
}

std::vector<NamedFile> outputsOf(const Invocation& invocation)
{
    std::vector<NamedFile> outputs;
    const auto add = [&outputs](const std::string& option, const std::string& path) {
        if (path == "-")
            throw Error(errors::valueNotUnderstood,
                        {{"parameter", option},
                         {"found", path},
                         {"expected", LT_TEXT("Engine", "the name of a file; only --json writes to standard output")}});
        if (!path.empty()) outputs.push_back(named(option, path));
    };
    for (const auto& [option, path] : invocation.request.outputs) add(option, path);
    if (invocation.common.json != "-") add("--json", invocation.common.json);
    add("--report", invocation.common.report);
    return outputs;
}

/// Standard output or standard error, when it goes into a file.
std::optional<NamedFile> streamFile(int descriptor, const char* name)
{
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return NamedFile{name, name, identityOf(status), {}};
}

}  // namespace

void checkOutputs(const Invocation& invocation)
{
    const std::vector<NamedFile> inputs = inputsOf(invocation);
    const std::vector<NamedFile> files = outputsOf(invocation);
    for (std::size_t i = 0; i < files.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (isSame(files[i], files[k]))
                throw Error(errors::outputsAreOne,
                            {{"parameter", files[i].option}, {"file", files[i].path}, {"other", files[k].option}});
    std::vector<NamedFile> outputs = files;
    const std::array<std::pair<int, const char*>, 2> streams{
        {{STDOUT_FILENO, "standard output"}, {STDERR_FILENO, "standard error"}}};
    for (const auto& [descriptor, name] : streams) {
        const auto stream = streamFile(descriptor, name);
        if (!stream) continue;
        for (const NamedFile& file : files)
            if (isSame(file, *stream))
                throw Error(errors::outputsAreOne,
                            {{"parameter", file.option}, {"file", file.path}, {"other", stream->option}});
        outputs.push_back(*stream);
    }
    for (const NamedFile& output : outputs)
        for (const NamedFile& input : inputs)
            if (isSame(output, input))
                throw Error(errors::outputIsInput, {{"parameter", output.option}, {"file", input.path}});
}

void watchOutputs(const Invocation& invocation)
{
    io::setWriteCheck([outputs = outputsOf(invocation)] {
        for (const NamedFile& output : outputs)
            if (const auto input = io::openedAs(output.path))
                throw Error(errors::outputIsInput, {{"parameter", output.option}, {"file", *input}});
    });
}

}  // namespace lathelier::cli
