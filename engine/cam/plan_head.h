// Comment head of a written program for the operator.
#pragma once

#include <string>
#include <vector>

#include "engine/cam/check/turning_check.h"
#include "engine/cam/clampings.h"
#include "engine/cam/drawn_features.h"
#include "engine/cam/post/post.h"
#include "engine/cam/reach.h"
#include "engine/cam/section_speeds.h"

namespace lathelier::cam {

/// Contents of the head.
struct HeadFacts {
    const Clamping& clamping;                ///< how the work is held
    const Shaft& part;                       ///< as drawn
    const std::vector<std::string>& origin;  ///< files and hashes
    const std::vector<SectionSpeed>& sections;
    std::vector<Unreached> rest;         ///< predicted residual material, as measured where it is known
    std::vector<DrawnFeature> not_made;  ///< by any operation; threads of this clamping alone
    std::size_t setup = 1, setups = 1;   ///< this clamping, of how many
    std::string check;                   ///< result of the check; empty: not known yet
};

/// Lines for comments; their number does not depend on `check`.
std::vector<std::string> headComments(const HeadFacts& facts, const Post& post);

/// Where material was measured, the figure of the measurement: what stays is bounded by the bar, which a prediction
/// from the curves of the tools is not. z of one clamping.
void setMeasured(std::vector<Unreached>& predicted, const std::vector<RestInterval>& measured);

/// "check: gouge 0.4 um, no findings".
std::string checkLine(const CheckResult& check);

}  // namespace lathelier::cam
