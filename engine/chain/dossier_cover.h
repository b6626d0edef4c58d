// The dossier on paper: two pages for the customer, and annexes that hold the reports of the steps.
#pragma once

#include <string>
#include <vector>

#include "engine/chain/dossier.h"
#include "engine/report/document.h"

namespace lathelier::chain {

/// The answer, what each step says, the part in six pictures, what is open, and the names of the annexes. A step that
/// was taken over from an earlier run has no picture.
report::Document dossierReport(const Dossier& dossier, const Language& language = {});

/// A report beside that of the dossier.
struct Annex {
    std::string file;  ///< name within the folder of the chain
    report::Document document;
};

/// One for each step that was run by this process, and one with notes, numbers and files of the chain. An annex of an
/// earlier run stays as it is. `inputs`: files of the whole chain.
std::vector<Annex> annexesOf(const Dossier& dossier, const std::vector<InputFile>& inputs);

}  // namespace lathelier::chain
