// The paper's shaft, worn, with the inputs of the chain from its scan to the proof of its copy.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// chain_worn.ply: the worn original; chain_drawing.json: its nominal drawing; chain_job.json, chain_setup.json: how it
/// is turned (the machine is spindle.json); chain_copy.ply: a scan of the copy as deflection predicts it for the
/// program that the job gives. The photographs of its long seat are those of surfaceSample(). The panel turning opens
/// drawing, job and machine, the chain all of them.
const SamplePart& chainSample();

}  // namespace lathelier::sample
