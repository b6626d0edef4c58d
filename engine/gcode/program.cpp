#include "engine/gcode/program.h"

#include <algorithm>

#include "engine/core/utf8.h"
#include "engine/gcode/block_scanner.h"
#include "engine/gcode/detection.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/word_classes.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/readable_text.h"

namespace lathelier::gcode {
namespace {

void refuseUnreadable(const std::string& text)
{
    if (text.empty()) throw Error(errors::fileEmpty, {});
    if (text.size() > largestProgram_bytes)
        throw Error(errors::ncTooLong, {{"found_MiB", static_cast<std::int64_t>(text.size() >> 20)},
                                        {"most_MiB", static_cast<std::int64_t>(largestProgram_bytes >> 20)}});
    const std::size_t nul = text.find('\0');
    // Punched tape begins and ends with NULs; elsewhere they indicate UTF-16 or binary data.
    const std::size_t from = text.find_first_not_of('\0');
    if (nul == std::string::npos) return;
    const std::size_t last = text.find_last_not_of('\0');
    if (from == std::string::npos || text.substr(from, last - from).find('\0') != std::string::npos)
        io::throwUnknownFormat(LT_TEXT("Engine", "bytes that are no text of an NC program"),
                               LT_TEXT("Engine", "a text with one byte for each character"));
}

/// The texts of the parts behind that of the program, each on lines of its own.
void append(const std::vector<ProgramPart>& parts, Program& program)
{
    for (const ProgramPart& part : parts) {
        try {
            refuseUnreadable(part.text);
        } catch (Error& error) {
            throw error.with("path", part.path);
        }
        if (program.text.back() != '\n') program.text += '\n';
        program.parts.push_back({part.name, part.path, static_cast<std::uint32_t>(program.text.size())});
        program.text += part.text.starts_with("\xEF\xBB\xBF") ? part.text.substr(3) : part.text;
        if (program.text.size() > largestProgram_bytes)
            throw Error(errors::ncTooLong, {{"found_MiB", static_cast<std::int64_t>(program.text.size() >> 20)},
                                            {"most_MiB", static_cast<std::int64_t>(largestProgram_bytes >> 20)}});
    }
}

}  // namespace

LinePlace Program::placeOf(std::int64_t line) const
{
    LinePlace place{{}, line};
    for (const PartPlace& part : parts)
        if (line > static_cast<std::int64_t>(part.first_block))
            place = {part.path, line - static_cast<std::int64_t>(part.first_block)};
    return place;
}

std::int64_t Program::columnOf(const Block& block, std::uint32_t offset) const
{
    std::string_view before = textOf(block).substr(0, offset - block.begin);
    if (block.begin == 0 && before.starts_with("\xEF\xBB\xBF")) before.remove_prefix(3);
    if (!is_utf8) return static_cast<std::int64_t>(before.size()) + 1;
    return std::count_if(before.begin(), before.end(), [](char c) { return static_cast<unsigned char>(c) >> 6 != 2; }) +
           1;
}

const Word* Program::wordOf(const Block& block, char letter) const
{
    for (std::uint32_t i = block.word_count; i-- > 0;) {
        const Word& word = words[block.first_word + i];
        if (word.letter == letter && (word.kind == WordKind::Number || word.kind == WordKind::Expression)) return &word;
    }
    return nullptr;
}

std::string shown(const Program& program, std::string_view part)
{
    if (program.is_utf8) return io::excerpt(part);
    std::string plain;
    for (const char c : part.substr(0, 60)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            plain += c;
        } else {
            plain += static_cast<char>(0xC0 | (byte >> 6));
            plain += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return io::excerpt(plain);
}

std::int64_t countWords(const Program& program)
{
    return std::count_if(program.words.begin(), program.words.end(),
                         [](const Word& word) { return word.kind != WordKind::Comment; });
}

std::int64_t countUnderstood(const Program& program)
{
    return std::count_if(program.words.begin(), program.words.end(), [](const Word& word) {
        return word.kind != WordKind::Comment && word.kind != WordKind::Bad && word.is_understood;
    });
}

Program readProgram(std::string text, const ControlPtr& control, const Progress& progress, std::string_view name,
                    const std::vector<ProgramPart>& parts)
{
    refuseUnreadable(text);
    Program program;
    program.text = std::move(text);
    program.own_bytes = program.text.size();
    const ControlFound found = control ? ControlFound{control, {}} : detectControl(program.text, name);
    if (!found.control->is_read)
        throw Error(errors::ncDialectNotRead, {{"line", std::max<std::int64_t>(found.line, 1)},
                                               {"found", found.control->label},
                                               {"dialect", found.control->label},
                                               {"expected", readControls()}});
    if (found.rival && found.has_axes)
        throw Error(errors::dialectUnclear, {{"line", std::max<std::int64_t>(found.line, 1)},
                                             {"first", found.control->label},
                                             {"second", found.rival->label},
                                             {"choices", found.control->key + ", " + found.rival->key}});
    program.control = found.control;
    append(parts, program);
    program.is_utf8 = isUtf8(program.text);
    program.names = declaredNames(program.text, *program.control);
    for (const PartPlace& part : program.parts) program.names.insert(part.name);
    const std::string& all = program.text;
    const auto lines = static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n')) + 1;
    program.blocks.reserve(lines);
    program.words.reserve(lines * 3);
    BlockScanner scanner(program);
    std::size_t at = 0, next_part = 0;
    while (at < all.size()) {
        if (next_part < program.parts.size() && at >= program.parts[next_part].begin)
            program.parts[next_part++].first_block = program.blocks.size();
        const std::size_t end = std::min(all.find_first_of("\r\n", at), all.size());
        Block block;
        block.begin = static_cast<std::uint32_t>(at);
        block.length = static_cast<std::uint32_t>(end - at);
        program.blocks.push_back(block);
        scanner.scan(program.blocks.back());
        classifyWords(program, program.blocks.back());
        at = end < all.size() && all[end] == '\r' && end + 1 < all.size() && all[end + 1] == '\n' ? end + 2 : end + 1;
        if (program.blocks.size() % 4096 == 0)
            progress.report(static_cast<double>(at) / static_cast<double>(all.size()));
    }
    return program;
}

std::vector<Word> wordsOfLine(std::string line, const ControlPtr& control)
{
    Program program;
    program.text = std::move(line);
    program.control = control;
    Block& block = program.blocks.emplace_back();
    block.length = static_cast<std::uint32_t>(program.text.size());
    BlockScanner(program).scan(block);
    classifyWords(program, block);
    return std::move(program.words);
}

namespace {

Diagnostic located(const Program& program, const Block& block, std::uint32_t offset)
{
    Diagnostic diagnostic;
    const LinePlace place = program.placeOf(program.lineOf(block));
    diagnostic.order = program.lineOf(block);
    diagnostic.path = place.path;
    diagnostic.line = place.line;
    diagnostic.column = program.columnOf(block, offset);
    diagnostic.block = shown(program, program.textOf(block));
    return diagnostic;
}

}  // namespace

void report(const Program& program, Diagnostics& list, const Block& block, std::uint32_t offset, const ErrorCode& code,
            Values values)
{
    if (!list.isNew(code.key, offset)) return;
    Diagnostic diagnostic = located(program, block, offset);
    diagnostic.is_error = true;
    diagnostic.code = code.key;
    diagnostic.pattern = code.pattern;
    diagnostic.values = values;
    diagnostic.error.emplace(code, std::move(values));
    if (!diagnostic.path.empty()) diagnostic.error->with("path", diagnostic.path);
    diagnostic.error->with("line", diagnostic.line).with("column", diagnostic.column).with("block", diagnostic.block);
    list.add(std::move(diagnostic));
}

void report(const Program& program, Diagnostics& list, const Block& block, std::uint32_t offset, const NoteCode& code,
            Values values, std::optional<GapEffect> gap)
{
    if (!list.isNew(code.key, offset)) return;
    Diagnostic diagnostic = located(program, block, offset);
    diagnostic.code = code.key;
    diagnostic.pattern = code.pattern;
    diagnostic.values = std::move(values);
    diagnostic.gap = gap;
    list.add(std::move(diagnostic));
}

}  // namespace lathelier::gcode
