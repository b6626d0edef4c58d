// Asks what a zone along the axis is: its name, its extent and its limits; or whether it is to be left out.
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

/// What a stretch drawn over the views stands for among the zones there are: the zone that its middle lies in, which is
/// then to be edited, else a new one without what other zones already have. Nothing where no room is left.
struct DrawnZone {
    registration::ZoneLimits zone;
    std::optional<std::size_t> existing;  ///< place among the zones; none: a new one
};
std::optional<DrawnZone> zoneAt(const std::vector<registration::ZoneLimits>& zones, double from_mm, double to_mm);

class ZoneDialog : public QDialog {
    Q_OBJECT
public:
    enum class Answer { Keep, LeaveOut, Remove };

    ZoneDialog(const registration::ZoneLimits& zone, bool exists, QWidget* parent);

    Answer answer() const { return answer_; }
    registration::ZoneLimits zone() const;

    void accept() override;  ///< refuses, with the reason, what is no zone

private:
    Form* form_;
    QLabel* problem_;
    Answer answer_ = Answer::Keep;
};

}  // namespace lathelier::compare_panel
