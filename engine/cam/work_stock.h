// The stock while a plan grows: what the operations so far have left of it, and whether a further one may run.
//
// Columns of engine/stock; places are those of the part (z from its finished free end). An operation is tried on a
// copy: rapid moves must not meet stock, chuck or tailstock with insert or holder, feed moves cut first and must not
// meet them with the holder. An operation that does is refused.
#pragma once

#include <optional>

#include "engine/cam/operation.h"
#include "engine/stock/stock_check.h"

namespace lathelier::cam {

/// What an operation met first.
struct Refusal {
    stock::FindingKind kind = stock::FindingKind::RapidThroughStock;  ///< what
    double z_mm = 0;                                                  ///< where, of the part
    double depth_mm = 0;                                              ///< how deep
};

class WorkStock {
public:
    /// `parameters`: as stockParameters(job) has them, tools among them. Errors of MeridianStock and outlineOf().
    WorkStock(const Shaft& stock, const stock::StockParameters& parameters);
    /// From what is left of another clamping.
    WorkStock(stock::MeridianStock stock, const stock::StockParameters& parameters);

    /// Does the tailstock stand there from now on? At first it does, where the parameters have one.
    void setTailstock(bool stands) { tailstock_stands_ = stands; }

    /// Cuts. None: nothing was met. What was met first is returned, and the stock is then as if it had been allowed.
    std::optional<Refusal> run(const Operation& operation);

    /// The least tip radius, from `x_mm` upward, down to which the tool may come straight from `safe_x_mm` at z.
    double reachableFromAbove_mm(int tool, double z_mm, double x_mm, double safe_x_mm) const;

    /// Largest radius of the stock between two places; 0 where there is none.
    double topBetween_mm(double from_mm, double to_mm) const;
    /// As a body for beams: columns of about `piece_mm`, from the free end of the stock to `to_z_mm`.
    Shaft bodyUpTo(double to_z_mm, double piece_mm) const;

    double removed_mm3() const { return removed_mm3_; }  ///< by feed moves so far
    const stock::MeridianStock& columns() const { return columns_; }

private:
    struct Mounted {
        int number = 0;
        stock::ConvexPolygon insert;
        std::vector<stock::ConvexPolygon> holders;
    };
    const Mounted* mounted(int number) const;
    bool meets(const stock::ConvexPolygon& swept) const;
    std::optional<Refusal> test(const stock::ConvexPolygon& swept, stock::FindingKind kind) const;

    stock::MeridianStock columns_;
    stock::StockParameters parameters_;
    std::vector<Mounted> tools_;
    std::vector<std::pair<stock::FindingKind, stock::ConvexPolygon>> regions_;
    double removed_mm3_ = 0;
    bool tailstock_stands_ = true;
};

}  // namespace lathelier::cam
