// Dialog of a zone along the axis: name, extent and limits, or exclusion.
#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "engine/registration/verdict/verdict_values.h"

class QLabel;

namespace lathelier {
class Form;
}

namespace lathelier::compare_panel {

/// Zone for an interval drawn in the views: the existing zone that contains its middle, to be edited, else a new one
/// reduced by the existing zones. None where no space is left.
struct DrawnZone {
    registration::ZoneLimits zone;
    std::optional<std::size_t> existing;  ///< index of the zone; none: a new one
};
std::optional<DrawnZone> zoneAt(const std::vector<registration::ZoneLimits>& zones, double from_mm, double to_mm);

class ZoneDialog : public QDialog {
    Q_OBJECT
public:
    enum class Answer { Keep, LeaveOut, Remove };

    ZoneDialog(const registration::ZoneLimits& zone, bool exists, QWidget* parent);

    Answer answer() const { return answer_; }
    registration::ZoneLimits zone() const;

    void accept() override;  ///< rejects an invalid zone with the reason

private:
    Form* form_;
    QLabel* problem_;
    Answer answer_ = Answer::Keep;
};

}  // namespace lathelier::compare_panel
