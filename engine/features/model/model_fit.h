// Damped least squares over the parameters of a model, all of them or those of a few neighbouring elements.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "engine/core/progress.h"
#include "engine/features/model/model.h"

namespace lathelier::features {

/// One free number of a model.
struct Slot {
    enum class Of { Plane, Level, Slope, CentreZ, CentreR, LogRadius };
    Of of = Of::Level;
    std::size_t run = 0;      ///< Plane: its index
    std::size_t element = 0;  ///< index into Run::elements
};

double& valueOf(Model& model, const Slot& slot);

/// The free numbers of elements [first, last] of a run, in order.
std::vector<Slot> slotsOf(const Model& model, std::size_t run, std::size_t first, std::size_t last);
/// All of the model: planes with a face first, then runs.
std::vector<Slot> allSlots(const Model& model);

/// Elements `first` to `last` (both included) of one run, whose walls are summed and whose slots are fitted.
struct Window {
    std::size_t run = 0, first = 0, last = 0;  ///< index into Model::runs
};

/// Huber's sum of squares (limit 4) over the walls within the window's elements, with penalties. A wall that does not
/// count is left out; `rows` is how many there are.
double misfit(const Model& model, const Window& window, std::size_t* rows = nullptr);

/// Local: Levenberg-Marquardt over the slots of the window's elements, their neighbours fixed. Gives misfit().
double fitWindow(Model& model, const Window& window, int iterations = 12);

/// The same over a given range of z.
double fitWindow(Model& model, const Window& window, double from_mm, double to_mm, int iterations);
double misfit(const Model& model, std::size_t run, double from_mm, double to_mm, std::size_t* rows = nullptr);

struct JointFit {
    double chi2 = 0;             ///< of all walls that count, Huber
    std::size_t rows = 0;        ///< walls that count
    Eigen::MatrixXd covariance;  ///< of the slots
    std::vector<Slot> slots;     ///< the free parameters, in the order of `covariance`
    bool converged = false;      ///< the last step changed nothing
};

/// All parameters of all runs together; planes are held by where they were seen.
JointFit fitAll(Model& model, int iterations, const Progress& progress = {});

}  // namespace lathelier::features
