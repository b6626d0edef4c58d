// Inserts and holders by their ISO codes: defaults for values that a job does not state.
//
// resources/library/inserts.json (the same that deflection reads) and holders.json. Geometry of inserts is that of ISO
// 1832; an insert that is not listed is read from its code: shape, edge length in whole mm, corner radius in 0.1 mm.
// Ranges of depth, feed and speed and the outlines of holders are assumed, as stated in their entries.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/cam/job.h"
#include "engine/core/error.h"
#include "engine/core/library.h"

namespace lathelier::cam {

/// An insert of the library.
struct LibraryInsert {
    double corner_radius_mm = 0;           ///< r
    double tip_angle_deg = 0;              ///< ε
    std::optional<double> lead_angle_deg;  ///< 90° - κ on the usual holder
    std::optional<double> edge_length_mm;
    std::optional<double> depth_low_mm, depth_high_mm;        ///< a_p
    std::optional<double> feed_low_mm_rev, feed_high_mm_rev;  ///< f
    std::optional<double> speed_low_m_min, speed_high_m_min;  ///< v_c
    std::string standing;                                     ///< of the ranges: "given" or "assumed"
    friend bool operator==(const LibraryInsert&, const LibraryInsert&) = default;
};

/// A holder of the library.
struct LibraryHolder {
    std::string name;                         ///< "PCLNL 2525M12"
    double entering_angle_deg = 0;            ///< κ
    Hand hand = Hand::TowardChuck;            ///< direction of its feed
    std::vector<stock::HolderCorner> holder;  ///< its hull is the holder
    std::string standing;                     ///< of the outline: "given" or "assumed"
    friend bool operator==(const LibraryHolder&, const LibraryHolder&) = default;
};

const std::vector<Field<LibraryInsert>>& fieldsOf(const LibraryInsert*);
const std::vector<Field<LibraryHolder>>& fieldsOf(const LibraryHolder*);

const std::vector<LibraryEntry<LibraryInsert>>& libraryInserts();
const std::vector<LibraryEntry<LibraryHolder>>& libraryHolders();

/// By code, letter case and blanks aside; an insert that is not listed by its ISO 1832 code. None: not parsed.
std::optional<LibraryInsert> insertNamed(const std::string& code);
const LibraryHolder* holderNamed(const std::string& code);

/// Values that tools do not state are filled from their named insert and holder; stated values take precedence. The
/// hand of the holder sets the hand of the tool. Error toolNotInLibrary.
Job withLibrary(Job job);

/// Notes on the values taken from the library, with source and status. Notes: toolFromLibrary.
void noteLibrary(const Job& stated, Notes& notes);

/// True if the holder outline is an assumed one of the library.
bool isHolderAssumed(const JobTool& tool);

/// Depths and feeds outside the ranges of the named inserts. Notes: outsideRange.
void noteRanges(const Job& job, Notes& notes);

/// True if insert and holder match by their codes: shape, clearance, edge length (ISO 1832, ISO 5608); also if a code
/// lacks them.
bool fitsHolder(const std::string& insert, const std::string& holder);

/// Notes: insertNotOfHolder.
void noteFits(const Job& job, Notes& notes);

}  // namespace lathelier::cam
