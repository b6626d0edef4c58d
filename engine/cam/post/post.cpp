#include "engine/cam/post/post.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/cam/plan_codes.h"
#include "engine/cam/post/built_in_posts.h"
#include "engine/gcode/controls/controls.h"
#include "engine/io/io_codes.h"
#include "engine/io/json/json_document.h"

namespace lathelier::cam {
namespace {

using io::JsonCursor;

constexpr std::size_t mostTemplateLines = 100;
constexpr std::size_t mostPostKeys = 200;
constexpr std::size_t longestTemplate = 200;
constexpr int mostWordDecimals = 6;

const Text textExpected = LT_TEXT("Engine", "a text");
const Text listExpected = LT_TEXT("Engine", "a list of texts");

/// A text of one line that a program may hold.
std::string oneLine(const JsonCursor& cursor)
{
    std::string text = cursor.string();
    if (text.size() > longestTemplate) cursor.reject(LT_TEXT("Engine", "a text of at most 200 characters"));
    for (const char c : text)
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E)
            cursor.reject(LT_TEXT("Engine", "printable ASCII characters"));
    return text;
}

/// A template; each name in braces must be a value of the writer.
std::string oneTemplate(const JsonCursor& cursor, bool of_cycle)
{
    std::string text = oneLine(cursor);
    for (std::size_t at = 0; (at = text.find_first_of("{}", at)) != std::string::npos;) {
        const std::size_t end = text.find('}', at);
        static constexpr const char* known[]{"title", "number", "tool", "tool2", "max_rpm", "vc", "rpm"};
        static constexpr const char* cycles[]{"first",       "last",        "depth", "retract",
                                              "x_allowance", "z_allowance", "feed"};
        const auto names = [&](const auto& words) {
            return std::any_of(std::begin(words), std::end(words),
                               [&](const char* name) { return text.substr(at + 1, end - at - 1) == name; });
        };
        const bool is_closed = text[at] == '{' && end != std::string::npos;
        if (!is_closed || !(names(known) || (of_cycle && names(cycles))))
            cursor.reject(of_cycle ? LT_TEXT("Engine",
                                             "braces around first, last, depth, retract, x_allowance, z_allowance, "
                                             "feed, or what other templates name")
                                   : LT_TEXT("Engine", "braces around title, number, tool, tool2, max_rpm, vc or rpm"));
        at = end + 1;
    }
    return text;
}

class Reader {
public:
    explicit Reader(const JsonCursor& root) : root_(root) {}

    Post run(Notes& notes)
    {
        post_.name = root_.at("name", textExpected).string();
        if (const auto label = root_.member("label")) post_.label = label->string();
        if (const auto dialect = root_.member("dialect")) readDialect(*dialect);
        static const std::pair<const char*, Templates Post::*> demanded[]{
            {"program_start", &Post::program_start}, {"header_comments", &Post::header_comments},
            {"safe_start", &Post::safe_start},       {"tool_start", &Post::tool_start},
            {"tool_end", &Post::tool_end},           {"spindle_css", &Post::spindle_css},
            {"spindle_rpm", &Post::spindle_rpm},     {"speed_change", &Post::speed_change},
            {"coolant_on", &Post::coolant_on},       {"program_end", &Post::program_end}};
        for (const auto& [key, member] : demanded) post_.*member = templates(root_.at(key, listExpected));
        static const std::pair<const char*, Templates Post::*> offered[]{
            {"stop", &Post::stop},
            {"optional_stop", &Post::optional_stop},
            {"work_offset", &Post::work_offset},
            {"tool_start_tailstock", &Post::tool_start_tailstock},
            {"program_end_tailstock", &Post::program_end_tailstock}};
        for (const auto& [key, member] : offered)
            if (const auto list = root_.member(key)) post_.*member = templates(*list);
        readCycles();
        static const std::pair<const char*, std::string Post::*> words[]{
            {"rapid", &Post::rapid}, {"line", &Post::line}, {"arc_cw", &Post::arc_cw}, {"arc_ccw", &Post::arc_ccw}};
        for (const auto& [key, member] : words) {
            const JsonCursor cursor = root_.at(key, textExpected);
            if ((post_.*member = oneLine(cursor)).empty()) cursor.reject(LT_TEXT("Engine", "a word such as G1"));
        }
        if (const auto thread = root_.member("thread")) post_.thread = oneLine(*thread);
        if (const auto lead = root_.member("thread_lead"))
            post_.thread_lead = choice(*lead, {"F", "K"}, LT_TEXT("Engine", "F or K")) == 0 ? "F" : "K";
        post_.arc = static_cast<ArcWords>(
            choice(root_.at("arc", textExpected), {"ik", "r", "cr"}, LT_TEXT("Engine", "ik, r or cr")));
        readWords(root_.at("words", LT_TEXT("Engine", "an object with X, Z, F and style")));
        if (const auto modal = root_.member("modal")) post_.modal = modal->flag();
        if (const auto feed = root_.member("feed"))
            post_.feed_per_min = choice(*feed, {"per_rev", "per_min"}, LT_TEXT("Engine", "per_rev or per_min")) == 1;
        if (const auto css = root_.member("css")) post_.css = css->flag();
        if (const auto numbers = root_.member("block_numbers"))
            post_.block_numbers = BlockNumbers{whole(numbers->at("start", LT_TEXT("Engine", "a number")), 0, 99999),
                                               whole(numbers->at("step", LT_TEXT("Engine", "a number")), 1, 1000)};
        readComment(root_.at("comment", LT_TEXT("Engine", "an object with open and close")));
        if (const auto end = root_.member("end_of_line"))
            post_.end_of_line = choice(*end, {"lf", "crlf"}, LT_TEXT("Engine", "lf or crlf")) == 0 ? "\n" : "\r\n";
        if (post_.css && post_.spindle_css.empty())
            root_.at("spindle_css", listExpected).reject(LT_TEXT("Engine", "lines, or css false"));
        noteUnknown(notes);
        return std::move(post_);
    }

private:
    static int choice(const JsonCursor& cursor, std::initializer_list<const char*> keys, Text expected)
    {
        const std::string found = cursor.string();
        int index = 0;
        for (const char* key : keys) {
            if (found == key) return index;
            ++index;
        }
        cursor.reject(expected);
    }

    void readDialect(const JsonCursor& cursor)
    {
        post_.control = gcode::controlNamed(cursor.string());
        if (!post_.control || !post_.control->is_read)
            cursor.reject(LT_TEXT("Engine", "a dialect: fanuc, fanuc_b, fanuc_c, haas, sinumerik or linuxcnc"));
    }

    static int whole(const JsonCursor& cursor, int least, int most)
    {
        const std::int64_t value = cursor.integer();
        if (value < least || value > most) {
            const io::JsonPlace place = cursor.place();
            throw Error(errors::keyOutOfRange, {{"key", LT_TEXT("Engine", "the number")},
                                                {"line", place.line},
                                                {"column", place.column},
                                                {"found", value},
                                                {"minimum", std::int64_t{least}},
                                                {"maximum", std::int64_t{most}}});
        }
        return static_cast<int>(value);
    }

    static Templates templates(const JsonCursor& list, bool of_cycle = false)
    {
        Templates result;
        list.items(mostTemplateLines, [&](const JsonCursor& item) { result.push_back(oneTemplate(item, of_cycle)); });
        return result;
    }

    void readCycles()
    {
        if (const auto rough = root_.member("rough_cycle")) post_.rough_cycle = templates(*rough, true);
        if (const auto finish = root_.member("finish_cycle")) post_.finish_cycle = templates(*finish, true);
        const auto cycles = root_.member("cycles");
        if (!cycles) return;
        post_.cycles = choice(*cycles, {"none", "g71_g70"}, LT_TEXT("Engine", "none or g71_g70")) == 1;
        if (!post_.cycles || !post_.rough_cycle.empty()) return;
        const gcode::ControlPtr control = post_.control;
        if (!control || meaningOfG(*control, 710) != gcode::G::RoughTurn ||
            meaningOfG(*control, 700) != gcode::G::Finish)
            cycles->reject(LT_TEXT("Engine", "none, for a control that has no G71; or the templates of rough_cycle"));
        post_.rough_cycle = {"G71 U{depth} R{retract}", "G71 P{first} Q{last} U{x_allowance} W{z_allowance} F{feed}"};
        post_.finish_cycle = {"G70 P{first} Q{last}"};
    }

    void readWords(const JsonCursor& words)
    {
        const Text number = LT_TEXT("Engine", "a number of decimals");
        const JsonCursor x = words.at("X", LT_TEXT("Engine", "an object with diameter and decimals"));
        post_.x_is_diameter = x.at("diameter", LT_TEXT("Engine", "true or false")).flag();
        post_.x_decimals = whole(x.at("decimals", number), leastDecimals, mostWordDecimals);
        const Text object = LT_TEXT("Engine", "an object with decimals");
        post_.z_decimals = whole(words.at("Z", object).at("decimals", number), leastDecimals, mostWordDecimals);
        post_.f_decimals = whole(words.at("F", object).at("decimals", number), 0, mostWordDecimals);
        if (const auto style = words.member("style"))
            post_.decimal_point = choice(*style, {"point", "plain"}, LT_TEXT("Engine", "point or plain")) == 0;
    }

    void readComment(const JsonCursor& comment)
    {
        const JsonCursor open = comment.at("open", textExpected);
        if ((post_.comment_open = oneLine(open)).empty()) open.reject(LT_TEXT("Engine", "how a comment begins"));
        post_.comment_close = oneLine(comment.at("close", textExpected));
        if (const auto length = comment.member("max_length")) post_.comment_length = whole(*length, 8, 200);
    }

    void noteUnknown(Notes& notes) const
    {
        static constexpr const char* known[]{"name",
                                             "label",
                                             "dialect",
                                             "program_start",
                                             "header_comments",
                                             "safe_start",
                                             "tool_start",
                                             "tool_end",
                                             "spindle_css",
                                             "spindle_rpm",
                                             "speed_change",
                                             "coolant_on",
                                             "program_end",
                                             "stop",
                                             "optional_stop",
                                             "work_offset",
                                             "rapid",
                                             "tool_start_tailstock",
                                             "program_end_tailstock",
                                             "line",
                                             "arc_cw",
                                             "arc_ccw",
                                             "arc",
                                             "thread",
                                             "thread_lead",
                                             "words",
                                             "modal",
                                             "feed",
                                             "css",
                                             "comment",
                                             "block_numbers",
                                             "end_of_line",
                                             "cycles",
                                             "rough_cycle",
                                             "finish_cycle",
                                             "about",
                                             "source"};
        root_.members(mostPostKeys, [&](const std::string& key, const JsonCursor& value) {
            if (std::any_of(std::begin(known), std::end(known), [&](const char* name) { return key == name; })) return;
            const io::JsonPlace place = value.place();
            notes.push_back({notes::unknownKey, {{"key", key}, {"line", place.line}, {"column", place.column}}});
        });
    }

    const JsonCursor& root_;
    Post post_;
};

}  // namespace

std::ptrdiff_t linesBeforeTool(const Templates& templates)
{
    return std::find_if(templates.begin(), templates.end(),
                        [](const std::string& line) { return line.find("{tool") != std::string::npos; }) -
           templates.begin();
}

const Templates& optionalStop(const Post& post)
{
    if (post.optional_stop.empty())
        throw Error(errors::postCannot, {{"post", post.name}, {"what", LT_TEXT("Engine", "stop optionally")}});
    return post.optional_stop;
}

Templates statedOffset(const Post& post)
{
    if (post.work_offset.empty())
        throw Error(errors::postCannot, {{"post", post.name}, {"what", LT_TEXT("Engine", "state the work offset")}});
    const auto holds = [&](const std::string& line) {
        return line.find(post.work_offset.front()) != std::string::npos;
    };
    return std::any_of(post.safe_start.begin(), post.safe_start.end(), holds) ? Templates{} : post.work_offset;
}

Post readPost(const std::string& json, Notes& notes)
{
    const io::JsonDocument document{json};
    return Reader(document.root()).run(notes);
}

std::string postText(const Post& post)
{
    Json json;
    json["name"] = post.name;
    if (!post.label.empty()) json["label"] = post.label;
    if (post.control) json["dialect"] = post.control->key;
    json["program_start"] = post.program_start;
    json["header_comments"] = post.header_comments;
    json["safe_start"] = post.safe_start;
    json["tool_start"] = post.tool_start;
    json["tool_start_tailstock"] = post.tool_start_tailstock;
    json["tool_end"] = post.tool_end;
    json["spindle_css"] = post.spindle_css;
    json["spindle_rpm"] = post.spindle_rpm;
    json["speed_change"] = post.speed_change;
    json["coolant_on"] = post.coolant_on;
    json["stop"] = post.stop;
    if (!post.optional_stop.empty()) json["optional_stop"] = post.optional_stop;
    if (!post.work_offset.empty()) json["work_offset"] = post.work_offset;
    json["program_end"] = post.program_end;
    json["program_end_tailstock"] = post.program_end_tailstock;
    json["cycles"] = post.cycles ? "g71_g70" : "none";
    if (!post.rough_cycle.empty()) json["rough_cycle"] = post.rough_cycle;
    if (!post.finish_cycle.empty()) json["finish_cycle"] = post.finish_cycle;
    json["rapid"] = post.rapid;
    json["line"] = post.line;
    json["arc_cw"] = post.arc_cw;
    json["arc_ccw"] = post.arc_ccw;
    if (!post.thread.empty()) json["thread"] = post.thread;
    json["thread_lead"] = post.thread_lead;
    static constexpr const char* arcs[]{"ik", "r", "cr"};
    json["arc"] = arcs[static_cast<std::size_t>(post.arc)];
    json["words"]["X"]["diameter"] = post.x_is_diameter;
    json["words"]["X"]["decimals"] = post.x_decimals;
    json["words"]["Z"]["decimals"] = post.z_decimals;
    json["words"]["F"]["decimals"] = post.f_decimals;
    json["words"]["style"] = post.decimal_point ? "point" : "plain";
    json["modal"] = post.modal;
    json["feed"] = post.feed_per_min ? "per_min" : "per_rev";
    json["css"] = post.css;
    json["block_numbers"] = nullptr;
    if (post.block_numbers) {
        json["block_numbers"]["start"] = post.block_numbers->start;
        json["block_numbers"]["step"] = post.block_numbers->step;
    }
    json["comment"]["open"] = post.comment_open;
    json["comment"]["close"] = post.comment_close;
    json["comment"]["max_length"] = post.comment_length;
    json["end_of_line"] = post.end_of_line == "\n" ? "lf" : "crlf";
    return json.dump(1) + "\n";
}

std::vector<std::string> postNames()
{
    std::vector<std::string> names;
    for (const BuiltInText& post : builtInPosts()) names.emplace_back(post.name);
    return names;
}

Post postNamed(const std::string& name)
{
    std::string all;
    for (const BuiltInText& post : builtInPosts()) {
        if (name == post.name) {
            Notes none;
            return readPost(post.text, none);
        }
        all += (all.empty() ? "" : ", ") + std::string(post.name);
    }
    throw Error(errors::postUnknown, {{"found", name}, {"expected", all}});
}

}  // namespace lathelier::cam
