// Kinds of file, each described once: inspect, drag and drop, file dialogs, import lines and the inputs of panels read
// this. A room with files of its own describes them in a header of its own; who reads them names them in the table of
// verbs or panels.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/io/import.h"
#include "engine/io/input_files.h"

namespace lathelier::io {

/// How much the head of a file speaks for a kind. Possible: nothing speaks against it.
enum class Likeness { No, Possible, Likely, Certain };

/// A file that is to be read in full.
struct FileToRead {
    std::string path;          ///< for messages, and to find what lies beside it
    std::string_view bytes;    ///< whole content; held by `inputs`
    const Values& reading;     ///< ImportOptions and those of the kind
    InputFiles& inputs;        ///< where further files that belong to it are opened
    const Progress& progress;  ///< receives the progress; throws Cancelled when stopped
};

struct FileKind {
    std::string key;                 ///< "probe_record"
    Text name;                       ///< "Probe records", for file dialogs
    std::string patterns;            ///< "*.csv *.dat *.par"
    std::vector<FieldInfo> reading;  ///< what such a file may leave open, besides ImportOptions
    Values reading_defaults;         ///< of these fields
    /// What the first headForKind bytes say. Never throws for a file of another kind; may look at the name and at the
    /// files beside.
    std::function<Likeness(const std::string& path, std::string_view head, const Values& reading)> sniff;
    /// "What I understood of this file", for inspect. Errors of its reader.
    std::function<FileFacts(const FileToRead& file, Notes& notes)> facts;
    /// Of a list of paths, each file once where several make one (.dat and .par); none: as they are.
    std::function<std::vector<std::string>(const std::vector<std::string>& paths)> counted_once = {};
};

using FileKinds = std::vector<const FileKind*>;

/// The kind that the head of a file speaks for most, the first of equals, and how much; nullptr when all say no.
struct KindFound {
    const FileKind* kind = nullptr;    ///< nullptr: none
    Likeness likeness = Likeness::No;  ///< how much the head speaks for it
};
KindFound likeliestKind(const FileKinds& kinds, const std::string& path, std::string_view head, const Values& reading);

/// The same for a file on the disk; none where it cannot be read.
KindFound findKind(const FileKinds& kinds, const std::string& path, const Values& reading = {});

/// Adds to `kinds` those of `more` that are not in it yet.
void unite(FileKinds& kinds, const FileKinds& more);

/// Clouds and meshes; also any table that is nothing else.
const FileKind& scanFiles();
const FileKind& profileFiles();
/// Tables and L-Graph pairs.
const FileKind& probeRecordFiles();
/// Q-DAS characteristics.
const FileKind& qdasFiles();
/// Frequency responses: universal files, tables, MAT files.
const FileKind& frfFiles();

}  // namespace lathelier::io
