// The library of inserts and holders by their ISO codes, the same for every task: what is added to
// resources/library/inserts.json or holders.json is a choice of deflection and a name that jobs may use.
//
// Files as io::readLibrary(): "inserts" and "holders" with the fields of LibraryTool. Geometry of inserts is that of
// ISO 1832, their entering angle that of the usual holder. Ranges of depth, feed and speed and the outlines of holders
// are assumed, as stated in their entries. There are no cutting coefficients: they belong to the pair of material and
// insert.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/built_in_text.h"
#include "engine/core/library.h"
#include "engine/core/tool.h"

namespace lathelier::cutting {

/// Cutting data that an insert is made for; none: no limit.
struct CuttingRanges {
    std::optional<double> depth_low_mm, depth_high_mm;        ///< a_p
    std::optional<double> feed_low_mm_rev, feed_high_mm_rev;  ///< f
    std::optional<double> speed_low_m_min, speed_high_m_min;  ///< v_c
    friend bool operator==(const CuttingRanges&, const CuttingRanges&) = default;
};

/// An insert or a holder: what it states of a Tool.
struct LibraryTool : Tool {
    CuttingRanges ranges;
    std::string standing;  ///< of ranges and outline: "given" or "assumed"
    std::string label;     ///< "CNMG 120408, 95°": name, else key, and entering angle; made by readToolLibrary()
    friend bool operator==(const LibraryTool&, const LibraryTool&) = default;
};

const std::vector<Field<CuttingRanges>>& fieldsOf(const CuttingRanges*);
const std::vector<Field<LibraryTool>>& fieldsOf(const LibraryTool*);

struct ToolLibrary {
    std::vector<LibraryEntry<LibraryTool>> inserts;  ///< with corner radius, tip angle and entering angle
    std::vector<LibraryEntry<LibraryTool>> holders;  ///< with entering angle
};

/// Errors with line and column: malformed, keyMissing, keyOutOfRange, valueStatedTwice.
ToolLibrary readToolLibrary(const std::string& inserts_json, const std::string& holders_json);

const std::vector<BuiltInText>& builtInInserts();  ///< resources/library/inserts.json
const std::vector<BuiltInText>& builtInHolders();  ///< resources/library/holders.json

/// The library that is built in. Thread-safe; lives as long as the program.
const ToolLibrary& toolLibrary();

/// By code, letter case and blanks aside; nullptr: not listed.
const LibraryEntry<LibraryTool>* entryNamed(const std::vector<LibraryEntry<LibraryTool>>& entries,
                                            const std::string& code);

/// The same of an insert, or of one that is not listed by its ISO 1832 code. None: not parsed.
std::optional<LibraryTool> insertNamed(const std::string& code, const ToolLibrary& library = toolLibrary());

/// Inserts as choices of a field; the first one, "stated", is called `stated`. Their names live as long as the library.
std::vector<FieldChoice> insertChoices(Text stated, const ToolLibrary& library = toolLibrary());

/// True if insert and holder match by their codes: shape, clearance, edge length (ISO 1832, ISO 5608); also if a code
/// lacks them.
bool fitsHolder(const std::string& insert, const std::string& holder);

}  // namespace lathelier::cutting
