// What the chain works on in the project: its own inputs, what it takes from the panels of the steps where they are not
// given, and its choices.
#pragma once

#include <string>
#include <vector>

#include "engine/chain/chain_question.h"
#include "engine/deflection/identification.h"
#include "engine/project/project.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier::chain_panel {

inline constexpr const char* chainKey = "chain";  ///< of the panel and its state

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
inline constexpr const char* runKey = "run";  ///< of the settings; no form

struct ChainSettings {
    std::string folder;                                                 ///< of the chain; empty: none was run
    std::string confirmed_by;                                           ///< who answers for the drawing
    std::optional<double> tolerance_mm;                                 ///< of the copy's surface
    std::optional<double> tolerance_um;                                 ///< of the predicted diameter error
    std::optional<double> photograph_z_mm;                              ///< place of the photographs
    std::optional<double> photograph_mm_px;                             ///< their scale
    std::optional<double> photograph_feed_deg;                          ///< direction of feed in them
    chain::CutInPicture photograph_cut = chain::CutInPicture::Unknown;  ///< direction of cut in them
    deflection::IdentificationParameters fit;                           ///< what is fitted to the copy
    std::string run;                                                    ///< SHA-256 of the dossier that was made last

    ChainSettings();
};

const std::vector<Field<ChainSettings>>& fieldsOf(const ChainSettings*);

std::vector<InputRole> chainRoles();

/// A file that the chain needs and that is an item, or was changed in a form: written before the chain runs.
struct MadeInput {
    std::string path;  ///< in the sub-folder "given" of the chain's folder, named by its content
    std::string text;  ///< of the file
};

struct AskedChain {
    chain::ChainQuestion question;
    std::vector<MadeInput> made;                    ///< to be written first
    std::optional<project::PanelState> deflection;  ///< of the panel whose set-up is taken; none: that of the chain
};

/// Named by its content.
MadeInput madeInput(const std::string& folder, const char* name, std::string text);

/// What would be run now. An input of its own rules over that of a panel; what the chain itself has put into a panel is
/// none.
AskedChain askedChain(const project::Project& project);

/// Where the files of a chain go that was never run: beside the scan, else beside the job; empty: neither is there.
std::string proposedFolder(const chain::ChainQuestion& question);

}  // namespace lathelier::chain_panel
