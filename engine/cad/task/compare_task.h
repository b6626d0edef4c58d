// The task compare: how far is a copy from its original or its drawing, where, and how sure is that? The verb and the
// panel Compare.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/cad/task/compare_inputs.h"
#include "engine/core/skin.h"
#include "engine/features/comparison/shaft_comparison.h"
#include "engine/registration/compare.h"
#include "engine/registration/copies.h"

namespace lathelier::cad {

/// Local means of the deviation, for the views.
struct DeviationForm {
    /// By point of the copy; NaN where it is not significant (surface_form.h). Null: none.
    std::shared_ptr<const std::vector<float>> local_mean_mm;
    /// For each point of the copy: 1 or -1 on a face across the axis that faces along it or against it, else 0; null
    /// where there are no faces.
    std::shared_ptr<const std::vector<std::int8_t>> along_axis;
    std::shared_ptr<const std::vector<float>> map_mean_mm;  ///< by cell of the unrolled map; null where there is none
    std::shared_ptr<const Skin> skin;                       ///< in the frame of the axis; null: no body of revolution
};

struct CompareOutcome : task::Answered {
    CompareQuestion question;                                   ///< the zones of a file included
    std::shared_ptr<const LoadedScan> copy;                     ///< never null
    std::shared_ptr<const LoadedScan> original;                 ///< null: a drawing, before addViews()
    ReferenceTaken reference;                                   ///< what the copy was compared with
    std::shared_ptr<const features::ShaftComparison> sizes;     ///< null: the reference is a scan
    std::shared_ptr<const registration::CompareResult> result;  ///< that of the surface; never null
    DeviationForm form;                                         ///< empty before addViews()
    std::vector<registration::CopySummary> copies;  ///< the copy and the further ones; empty: not compared, or none
    std::vector<report::Picture> pictures;          ///< of the views, for the report

    const Scan& copyScan() const { return copy->file.scan; }
    std::string scansKey() const;  ///< changes with the content of both and with how they were read
};

/// Without the further copies. Another limit or rule aligns nothing anew. Errors: those of takeReference(), ScanInput,
/// ZonesInput, compare(), compareWithShaft(). Throws Cancelled.
CompareOutcome answerCompare(const project::PanelState& state, registration::CompareDetail detail, Stores& stores,
                             task::Sources& sources, const Progress& progress);

/// What views show besides: the mesh of a drawing, and local means. Precondition: CompareDetail::Full.
void addViews(CompareOutcome& outcome, Stores& stores, const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const CompareOutcome>& outcome);

inline constexpr const char* deviationsExport = "deviations";

const task::Task& compareTask();

}  // namespace lathelier::cad
