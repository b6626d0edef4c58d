// Inserts and holders by their ISO codes: what a job need not state of a tool.
//
// resources/library/inserts.json (the same that deflection reads) and holders.json. Geometry of inserts is that of ISO
// 1832; an insert that is not listed is read from its code: shape, edge length in whole mm, corner radius in 0.1 mm.
// Ranges of depth, feed and speed and the outlines of holders are assumed, as their entries say.
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
    double corner_radius_mm = 0;                              ///< r
    double tip_angle_deg = 0;                                 ///< ε
    std::optional<double> lead_angle_deg;                     ///< 90° - κ on the usual holder
    std::optional<double> edge_length_mm;                     ///< of the edge
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

/// By code, letter case and blanks aside; an insert that is not listed by its ISO 1832 code. None: not understood.
std::optional<LibraryInsert> insertNamed(const std::string& code);
const LibraryHolder* holderNamed(const std::string& code);

/// What tools do not state is filled from the insert and the holder that they name; what is typed rules. A holder that
/// cuts from the chuck makes the tool do so. Error toolNotInLibrary.
Job withLibrary(Job job);

/// What the tools of a job take from the library, with its source and standing. Notes: toolFromLibrary.
void noteLibrary(const Job& stated, Notes& notes);

/// Does the outline of this tool's holder come from the library, where it is assumed?
bool isHolderAssumed(const JobTool& tool);

/// Depths and feeds outside the ranges of the named inserts. Notes: outsideRange.
void noteRanges(const Job& job, Notes& notes);

/// Does an insert fit a holder, by their codes: shape, clearance, and length of the edge (ISO 1832, ISO 5608)? Yes
/// where a code does not tell.
bool fitsHolder(const std::string& insert, const std::string& holder);

/// Notes: insertNotOfHolder.
void noteFits(const Job& job, Notes& notes);

}  // namespace lathelier::cam
