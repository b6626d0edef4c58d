// State of the chain in the project: its inputs, inputs taken over from the panels of its steps, and its settings.
#pragma once

#include <string>
#include <vector>

#include "engine/chain/chain_question.h"
#include "engine/deflection/identification.h"
#include "engine/project/project.h"

namespace lathelier::chain {

inline constexpr const char* chainKey = "chain";  ///< id of the panel and of its state

// Roles of the inputs.
inline constexpr const char* scanRole = "scan";
inline constexpr const char* drawingRole = "shaft";
inline constexpr const char* machineRole = "spindle";
inline constexpr const char* jobRole = "job";
inline constexpr const char* setupRole = "setup";
inline constexpr const char* copyRole = "copy";
inline constexpr const char* beforeRole = "before";
inline constexpr const char* afterRole = "after";

inline constexpr const char* folderKey = "folder";
inline constexpr const char* runKey = "run";  ///< key of ChainSettings::run; not in the form

struct ChainSettings {
    std::string folder;                                   ///< folder of the chain; empty: none was run
    std::string confirmed_by;                             ///< person who confirmed the drawing
    std::optional<double> tolerance_mm;                   ///< tolerance of the copy's surface
    std::optional<double> tolerance_um;                   ///< tolerance of the predicted diameter error
    std::optional<double> photograph_z_mm;                ///< z of the photographs
    std::optional<double> photograph_mm_px;               ///< scale of the photographs
    std::optional<double> photograph_feed_deg;            ///< direction of feed in the photographs
    CutInPicture photograph_cut = CutInPicture::Unknown;  ///< direction of cut in the photographs
    deflection::IdentificationParameters fit;             ///< parameters fitted to the copy
    std::string run;                                      ///< SHA-256 of the latest dossier

    ChainSettings();
};

const std::vector<Field<ChainSettings>>& fieldsOf(const ChainSettings*);

/// An input of the chain that is an item or was changed in a form: written to a file before the chain runs.
struct MadeInput {
    std::string path;  ///< in the sub-folder "given" of the chain's folder, named by its content
    std::string text;  ///< content of the file
};

struct AskedChain {
    ChainQuestion question;
    std::vector<MadeInput> made;                    ///< files to be written before the run
    std::optional<project::PanelState> deflection;  ///< state of the panel whose set-up is used; none: that of the
                                                    ///< chain
};

/// Name derived from its content.
MadeInput madeInput(const std::string& folder, const char* name, std::string text);

/// The question of a run now. The chain's own inputs have precedence over those of panels; inputs set in panels by the
/// chain itself are ignored.
AskedChain askedChain(const project::Project& project);

/// Makes the inputs of a question those of the chain, where it takes them from panels.
void pinInputs(project::Project& project, const ChainQuestion& question);

/// Default folder of a chain that was never run: beside the scan, else beside the job; empty: neither is given.
std::string proposedFolder(const ChainQuestion& question);

}  // namespace lathelier::chain
