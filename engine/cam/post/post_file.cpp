#include "engine/cam/post/post_file.h"

#include "engine/gcode/controls/controls.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_head.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::cam {
namespace {

io::Likeness likePost(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    const bool has_words = io::hasKey(keys, "tool_start") && io::hasKey(keys, "rapid");
    return has_words && !io::hasKey(keys, "command") ? io::Likeness::Certain : io::Likeness::No;
}

}  // namespace

PostFile loadPost(const io::FileToRead& file)
{
    PostFile loaded;
    try {
        const io::DecodedText text = io::decodeText(file.bytes, io::Encoding::Auto, file.progress);
        if (io::trimmed(text.view()).empty()) throw Error(errors::fileEmpty, {});
        loaded.post = readPost(std::string(text.view()), loaded.notes);
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
    for (Note& note : loaded.notes) set(note.values, "path", file.path);
    loaded.facts.path = file.path;
    loaded.facts.format = "post_json";
    set(loaded.facts.details, "name", loaded.post.name);
    const gcode::ControlPtr control = loaded.post.control;
    set(loaded.facts.details, "dialect", control ? Value(control->key) : Value());
    return loaded;
}

const io::FileKind& postFiles()
{
    static const io::FileKind kind{"post",
                                   LT_TEXT("Engine", "Posts of controls"),
                                   "*.json",
                                   {},
                                   {},
                                   likePost,
                                   [](const io::FileToRead& file, Notes& notes) {
                                       PostFile loaded = loadPost(file);
                                       notes.insert(notes.end(), loaded.notes.begin(), loaded.notes.end());
                                       return std::move(loaded.facts);
                                   }};
    return kind;
}

}  // namespace lathelier::cam
