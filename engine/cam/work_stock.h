// The stock after the operations planned so far, and the collision test of a further operation.
//
// Columns of engine/stock; places are those of the part (z from its finished free end). An operation is tried on a
// copy: rapid moves must not collide with stock, chuck or tailstock; feed moves first cut, then their holder must not
// collide. A colliding operation is refused.
#pragma once

#include <optional>

#include "engine/cam/operation.h"
#include "engine/stock/stock_check.h"

namespace lathelier::cam {

inline constexpr double approachClearance_mm = 0.1;  ///< of a rapid approach from the stock

/// First collision of an operation.
struct Refusal {
    stock::FindingKind kind = stock::FindingKind::RapidThroughStock;
    double z_mm = 0;  ///< where, of the part
    double depth_mm = 0;
};

class WorkStock {
public:
    /// `parameters`: as stockParameters(job) has them, tools among them. Errors of MeridianStock and outlineOf().
    WorkStock(const Shaft& stock, const stock::StockParameters& parameters);
    /// Starts from the stock of another clamping.
    WorkStock(stock::MeridianStock stock, const stock::StockParameters& parameters);

    /// Engages or disengages the tailstock. Initially engaged if the parameters have one.
    void setTailstock(bool stands) { tailstockStands_ = stands; }

    /// Removes the operation from the stock. Returns the first collision; the stock is cut in any case. None: no
    /// collision.
    std::optional<Refusal> run(const Operation& operation);

    /// Smallest tip radius ≥ `x_mm` that the tool can reach at z by a straight move from `safe_x_mm`, at least
    /// approachClearance_mm clear of the stock.
    double reachableFromAbove_mm(int tool, double z_mm, double x_mm, double safe_x_mm) const;

    /// Largest radius of the stock between two places; 0 without stock.
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
    bool tailstockStands_ = true;
};

}  // namespace lathelier::cam
