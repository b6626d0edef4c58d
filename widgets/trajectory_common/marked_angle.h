// The angle that all views of Roundness mark.
#pragma once

#include <QObject>
#include <optional>

namespace lathelier::trajectory_common {

/// Seen from the part, 0…360°. Lives in the GUI thread, one for each session (Stores).
class MarkedAngle : public QObject {
    Q_OBJECT

public:
    std::optional<double> angle_deg() const { return angle_deg_; }
    void set(std::optional<double> angle_deg);
    void takeBack();  ///< undoes the last set(), which was the first half of a double click

signals:
    void changed();

private:
    std::optional<double> angle_deg_;
    std::optional<double> before_deg_;
};

}  // namespace lathelier::trajectory_common
