// Inputs of a task: described once, read from a file or taken from an item of the project.
//
// A kind of input is a struct K that stands beside its reader (SetupInput in deflection/setup_file.h):
//   using File   what its reader makes of a file; has `notes`
//   using Value  what a task works on
//   static File read(const io::FileToRead&);
//   static Value valueOf(const File&);
//   static io::FileKinds kinds();                               empty: any file
//   static constexpr const char* item;                          kind of item, "": files only
//   static std::optional<Value> ofItem(const Values&);          where `item` is not empty; none: not such an item
//   static std::string contentOf(const Values&);                optional: text whose digest names the item
//   static constexpr std::size_t capacity;                      optional: files that a cache keeps
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/input_file.h"
#include "engine/core/progress.h"
#include "engine/io/file_kind.h"
#include "engine/project/input_key.h"
#include "engine/project/project.h"
#include "engine/task/stores.h"

namespace lathelier::task {

/// What was read for an answer; filled step by step, so that it is known where an error ends the run.
struct Sources {
    std::vector<InputFile> inputs;  ///< files and items, in the order in which they were read; partner files too
    Notes notes;                    ///< of their readers
    bool synthetic = false;         ///< a source is marked as synthetic

    void add(const std::vector<InputFile>& files, const Notes& of_reader, bool is_synthetic);
};

/// An input of a task.
struct Input {
    std::string role;          ///< key in PanelState::inputs: "setup"
    std::string option;        ///< of the command line, "setup"; empty: an operand
    std::string operand = {};  ///< its name on the help page; empty: the role in capitals
    Text label;                ///< shown name
    Text help;                 ///< what it is; one sentence
    bool required = true;
    io::FileKinds kinds = {};     ///< of its files
    std::string item_kind = {};   ///< kind of project items accepted instead of a file; empty: files only
    bool takes_files = true;      ///< false: items only, and nothing of the command line
    bool in_window_only = false;  ///< neither operand nor option of the command line
    bool several = false;         ///< more follow under "role.2", "role.3"…; of the command line the last operand
    bool is_of_part = false;      ///< changes from part to part; else it is that of all parts: reference, machine
    /// Reads it where it is given, for the facts that a window shows before all inputs are there. Errors of the reader.
    std::function<void(const project::PanelState&, Stores&, const Progress&)> read = {};
};

/// Files of a kind of input that were read, one cache for each kind.
template <class K>
class CacheOf : public FileCache<typename K::File> {
public:
    static constexpr std::size_t capacity = [] {
        if constexpr (requires { K::capacity; })
            return K::capacity;
        else
            return std::size_t{20};
    }();

    CacheOf() : FileCache<typename K::File>(capacity) {}

protected:
    typename K::File read(const project::Source& source, io::InputFiles& inputs,
                          const Progress& progress) const override
    {
        return K::read({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
    }
};

/// The source of an input; nullptr: not given.
const project::Source* sourceOf(const project::PanelState& state, const std::string& role);

/// What errors and notes call an input: its path, or the name of the item.
std::string nameOf(const project::Source& source);

/// The values of the item of an input. Error itemNotThere where the project has none of this kind.
const Values& itemValues(const project::PanelState& state, const std::string& role, const char* kind);

/// Error itemNotThere.
[[noreturn]] void throwItemNotThere(const std::string& item, const char* kind);

/// An item as an audit names it.
InputFile itemAsInput(const std::string& name, const std::string& content);
std::string contentOf(const Values& values);  ///< the values as JSON

namespace detail {

/// Calls `work`; an error gets the path of the source.
template <class Work>
auto naming(const project::Source& source, Work work)
{
    try {
        return work();
    } catch (Error& error) {
        throw error.with("path", nameOf(source));
    }
}

}  // namespace detail

/// The file of an input; nullptr: the input is not given, or is an item. Errors of the reader, with the path.
template <class K>
std::shared_ptr<const Loaded<typename K::File>> takeFile(const project::PanelState& state, const std::string& role,
                                                         Stores& stores, const Progress& progress, Sources& sources)
{
    const project::Source* const source = sourceOf(state, role);
    if (!source || !source->item.empty()) return nullptr;
    return detail::naming(*source, [&] {
        auto loaded = stores.of<CacheOf<K>>()->load(*source, progress);
        sources.add(loaded->inputs, loaded->file.notes, source->synthetic);
        return loaded;
    });
}

/// The value of an input, from its file or its item; none: not given. Errors of the reader, with the path;
/// itemNotThere. Throws Cancelled.
template <class K>
std::optional<typename K::Value> take(const project::PanelState& state, const std::string& role, Stores& stores,
                                      const Progress& progress, Sources& sources)
{
    const project::Source* const source = sourceOf(state, role);
    if (!source) return std::nullopt;
    if (const auto loaded = takeFile<K>(state, role, stores, progress, sources)) return K::valueOf(loaded->file);
    if constexpr (*K::item != '\0') {
        const Values& values = itemValues(state, role, K::item);
        std::optional<typename K::Value> value = K::ofItem(values);
        if (!value) throwItemNotThere(source->item, K::item);
        std::string content;
        if constexpr (requires { K::contentOf(values); })
            content = K::contentOf(values);
        else
            content = contentOf(values);
        sources.add({itemAsInput(source->item, content)}, {}, source->synthetic);
        return value;
    }
    throwItemNotThere(source->item, "");
}

/// An input of the kind K. `option`: of the command line; empty: an operand.
template <class K>
Input input(const char* role, const char* option, Text label, Text help)
{
    Input made;
    made.role = role;
    made.option = option;
    made.label = label;
    made.help = help;
    made.kinds = K::kinds();
    made.item_kind = K::item;
    made.read = [name = std::string(role)](const project::PanelState& state, Stores& stores, const Progress& progress) {
        Sources unused;
        for (const std::string& key : project::keysOf(state, name)) takeFile<K>(state, key, stores, progress, unused);
    };
    return made;
}

template <class K>
Input optionalInput(const char* role, const char* option, Text label, Text help)
{
    Input made = input<K>(role, option, label, help);
    made.required = false;
    return made;
}

/// The same input as one that changes from part to part.
Input ofPart(Input input);

}  // namespace lathelier::task
