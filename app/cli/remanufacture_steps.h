// The steps of `remanufacture`, each a verb of the command line or what prepares one.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/cli/chain_run.h"
#include "engine/cam/job.h"

namespace lathelier::cli {

/// Files and choices of the chain.
struct ChainFiles {
    std::string out;                     ///< folder
    std::string machine;                 ///< path
    std::string job;                     ///< path
    std::string setup;                   ///< path; empty: deflection is left out
    std::string copy;                    ///< path; empty: no copy yet
    std::string drawing;                 ///< path; empty: the drawing is what was recognised
    std::string confirmed_by;            ///< name of who answers for the drawing
    std::string post = "fanuc_a";        ///< control
    std::optional<double> tolerance_mm;  ///< of the copy's surface
    std::optional<double> tolerance_um;  ///< of the predicted diameter error
};

const std::vector<Field<ChainFiles>>& fieldsOf(const ChainFiles*);

/// To be called in this order; each step does nothing but record itself once an earlier one has failed.
class Remanufacture {
public:
    /// Reads the job. Errors of its reader; outputIsInput where an input lies in the folder. Throws Cancelled.
    Remanufacture(const Request& request, const ChainFiles& files, io::InputFiles& inputs, const Progress& progress);

    void recognise();
    void draw();
    void planSpeeds();
    void program();
    void deflect();
    void compareCopy();
    void prove();
    ChainRun& chain() { return chain_; }

private:
    void refuseOverwriting() const;
    void correct(StepRequest step);
    Progress share(double from, double to, Text stage) const { return progress_.part(from, to, stage); }

    const Request& request_;
    ChainFiles files_;
    io::InputFiles& inputs_;
    const Progress& progress_;
    ChainRun chain_;
    cam::Job job_;
    std::string shaft_;         // path of the drawing
    std::string program_;       // path of the first program
    double stock_zero_mm_ = 0;  // z of deflection's stock less z of the part
    Json drawn_, deflected_, compared_;
};

}  // namespace lathelier::cli
