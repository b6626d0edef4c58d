#include "widgets/compare/zone_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/core/form/form.h"
#include "widgets/core/form/typing.h"

namespace lathelier::compare_panel {
namespace {

constexpr double least_mm = 0.1;  // shorter drags are ignored

double rounded(double z_mm)
{
    return std::round(z_mm * 100) / 100;
}

}  // namespace

std::optional<DrawnZone> zoneAt(const std::vector<registration::ZoneLimits>& zones, double from_mm, double to_mm)
{
    DrawnZone drawn;
    drawn.zone.z_start_mm = rounded(std::min(from_mm, to_mm));
    drawn.zone.z_end_mm = rounded(std::max(from_mm, to_mm));
    const double middle = (drawn.zone.z_start_mm + drawn.zone.z_end_mm) / 2;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const registration::ZoneLimits& other = zones[i];
        if (middle >= other.z_start_mm && middle <= other.z_end_mm) return DrawnZone{other, i};
        if (other.z_end_mm < middle)
            drawn.zone.z_start_mm = std::max(drawn.zone.z_start_mm, other.z_end_mm);
        else
            drawn.zone.z_end_mm = std::min(drawn.zone.z_end_mm, other.z_start_mm);
    }
    if (drawn.zone.z_end_mm - drawn.zone.z_start_mm < least_mm) return std::nullopt;
    return drawn;
}

ZoneDialog::ZoneDialog(const registration::ZoneLimits& zone, bool exists, QWidget* parent)
    : QDialog(parent), form_(new Form(infos<registration::ZoneLimits>())), problem_(new QLabel)
{
    setObjectName("zoneDialog");
    setWindowTitle(exists ? tr("Zone") : tr("New zone"));
    form_->setValues(toValues(zone));
    problem_->setObjectName("problem");
    problem_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    const auto offer = [&](const QString& text, const char* name, Answer answer) {
        QPushButton* button = buttons->addButton(text, QDialogButtonBox::DestructiveRole);
        button->setObjectName(name);
        connect(button, &QPushButton::clicked, this, [this, answer] {
            answer_ = answer;
            QDialog::accept();
        });
    };
    if (exists)
        offer(tr("Remove"), "remove", Answer::Remove);
    else
        offer(tr("Leave out"), "leaveOut", Answer::LeaveOut);
    connect(buttons, &QDialogButtonBox::accepted, this, &ZoneDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(form_);
    layout->addWidget(problem_);
    layout->addStretch(1);
    layout->addWidget(buttons);
    resize(fontMetrics().averageCharWidth() * 55, sizeHint().height());
}

registration::ZoneLimits ZoneDialog::zone() const
{
    takeOverTyping(this);
    return fromValues<registration::ZoneLimits>(form_->values());
}

void ZoneDialog::accept()
{
    const registration::ZoneLimits asked = zone();
    if (!(asked.z_end_mm > asked.z_start_mm)) return problem_->setText(tr("The zone has to end beyond its start."));
    if (asked.lower_mm.has_value() != asked.upper_mm.has_value())
        return problem_->setText(tr("Give both limits, or none."));
    if (asked.lower_mm && !(*asked.upper_mm > *asked.lower_mm))
        return problem_->setText(tr("The upper limit has to be above the lower one."));
    QDialog::accept();
}

}  // namespace lathelier::compare_panel
