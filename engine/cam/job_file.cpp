#include "engine/cam/job_file.h"

#include <nlohmann/json.hpp>

#include "engine/cam/job_library.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_fields.h"
#include "engine/io/json/json_head.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::cam {
namespace {

io::Likeness likeJob(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    if (io::hasKey(keys, "command") || !io::hasKey(keys, "stock")) return io::Likeness::No;
    return io::hasKey(keys, "tools") && io::hasKey(keys, "cutting") ? io::Likeness::Certain
           : io::hasKey(keys, "tools")                              ? io::Likeness::Likely
                                                                    : io::Likeness::No;
}

}  // namespace

Job readJob(const std::string& json, Notes& notes)
{
    const io::JsonDocument document{json};
    const io::JsonCursor root = document.root();
    if (!root.isObject()) root.reject(LT_TEXT("Engine", "an object with stock, setup, tools and cutting"));
    root.at("stock", LT_TEXT("Engine", "the bar"));
    root.at("setup", LT_TEXT("Engine", "how the work is held"));
    root.at("tools", LT_TEXT("Engine", "a list of tools"));
    const io::JsonCursor cutting = root.at("cutting", LT_TEXT("Engine", "the cutting data"));
    cutting.at("rough", LT_TEXT("Engine", "the data of roughing"));
    cutting.at("finish", LT_TEXT("Engine", "the data of finishing"));
    auto job = io::readFields<Job>(root, notes, {"shaft"});
    if (const auto shaft = root.member("shaft")) job.shaft = io::readShaft(*shaft, notes);
    withLibrary(job);  // throws for inserts and holders that the library lacks
    return job;
}

std::string jobText(const Job& job)
{
    Json root = io::objectOf(infos<Job>(), lathelier::toValues(job));
    if (job.shaft) root["shaft"] = Json::parse(io::shaftText(*job.shaft));
    return root.dump(2) + "\n";
}

JobFile loadJob(const io::FileToRead& file)
{
    JobFile loaded;
    try {
        const io::DecodedText text = io::decodeText(file.bytes, io::Encoding::Auto, file.progress);
        if (io::trimmed(text.view()).empty()) throw Error(errors::fileEmpty, {});
        loaded.job = readJob(std::string(text.view()), loaded.notes);
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
    for (Note& note : loaded.notes) set(note.values, "path", file.path);
    const Job& job = loaded.job;
    io::FileFacts& facts = loaded.facts;
    facts.path = file.path;
    facts.format = "job_json";
    set(facts.details, "title", job.title);
    set(facts.details, "tools", static_cast<std::int64_t>(job.tools.size()));
    set(facts.details, "segments", job.shaft ? Value(static_cast<std::int64_t>(job.shaft->segments.size())) : Value());
    set(facts.details, "stock_diameter_mm", job.stock.diameter_mm);
    return loaded;
}

const io::FileKind& jobFiles()
{
    static const io::FileKind kind{"job",
                                   LT_TEXT("Engine", "Turning jobs"),
                                   "*.json",
                                   {},
                                   {},
                                   likeJob,
                                   [](const io::FileToRead& file, Notes& notes) {
                                       JobFile loaded = loadJob(file);
                                       notes.insert(notes.end(), loaded.notes.begin(), loaded.notes.end());
                                       return std::move(loaded.facts);
                                   }};
    return kind;
}

}  // namespace lathelier::cam
