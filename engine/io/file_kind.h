// Kinds of file, each described once: inspect, drag and drop, file dialogs, import lines and the inputs of panels read
// this. Each room describes its kinds in its own header; verbs and panels name them in their tables.
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

/// Confidence, from the head of a file, that it is of a kind. Possible: no evidence against it.
enum class Likeness { No, Possible, Likely, Certain };

/// A file that is to be read in full.
struct FileToRead {
    std::string path;          ///< for messages and for partner files in the same folder
    std::string_view bytes;    ///< whole content; owned by `inputs`
    const Values& reading;     ///< ImportOptions and those of the kind
    InputFiles& inputs;        ///< where further files that belong to it are opened
    const Progress& progress;  ///< receives the progress; throws Cancelled when stopped
};

struct FileKind {
    std::string key;                 ///< key of the kind, "probe_record"
    Text name;                       ///< "Probe records", for file dialogs
    std::string patterns;            ///< patterns of file names, "*.csv *.dat *.par"
    std::vector<FieldInfo> reading;  ///< reading options of the kind, besides ImportOptions
    Values reading_defaults;         ///< default values of `reading`
    /// Judges by the first headForKind bytes. Never throws for a file of another kind; may use the name and
    /// neighbouring files.
    std::function<Likeness(const std::string& path, std::string_view head, const Values& reading)> sniff;
    /// Facts of the file for `inspect`. Errors of its reader.
    std::function<FileFacts(const FileToRead& file, Notes& notes)> facts;
    /// Merges paths that form one input (.dat and .par); none: no merging.
    std::function<std::vector<std::string>(const std::vector<std::string>& paths)> counted_once = {};
};

using FileKinds = std::vector<const FileKind*>;

/// The most likely kind by the head of a file, the first of equals, with its likeness; nullptr when none matches.
struct KindFound {
    const FileKind* kind = nullptr;    ///< most likely kind; nullptr: none
    Likeness likeness = Likeness::No;  ///< confidence
};
KindFound likeliestKind(const FileKinds& kinds, const std::string& path, std::string_view head, const Values& reading);

/// The same for a file on the disk; none when it cannot be read.
KindFound findKind(const FileKinds& kinds, const std::string& path, const Values& reading = {});

/// Adds to `kinds` those of `more` that are not in it yet.
void unite(FileKinds& kinds, const FileKinds& more);

/// Clouds and meshes; also tables of no other kind.
const FileKind& scanFiles();
const FileKind& profileFiles();
/// Tables and L-Graph pairs.
const FileKind& probeRecordFiles();
/// Q-DAS characteristics.
const FileKind& qdasFiles();
/// Frequency responses: universal files, tables, MAT files.
const FileKind& frfFiles();

}  // namespace lathelier::io
