#include "widgets/longitudinal/longitudinal_views.h"

#include <QBuffer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/trajectory/trajectory_plots.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"
#include "widgets/longitudinal/section_table.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::longitudinal_panel {

LongitudinalViews::LongitudinalViews(trajectory_common::MarkedAngle& angle, QWidget* parent)
    : QWidget(parent),
      angle_(angle),
      section_(new trajectory_common::SectionBar),
      angleBar_(new trajectory_common::AngleBar(angle)),
      formOnly_(new QCheckBox),
      magnificationLabel_(new QLabel),
      magnification_(new QDoubleSpinBox),
      synthetic_(new QLabel),
      scene_(new scene::SceneView),
      profile_(new plot::ChartView),
      table_(new SectionTable),
      primaryViews_(new PrimaryViews)
{
    scene_->setObjectName("stack");
    profile_->setObjectName("profile");
    formOnly_->setObjectName("formOnly");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    buildBar();
    primaryViews_->add("stack", scene_);
    primaryViews_->add("profile", profile_);
    primaryViews_->add("sections", table_);
    layout->addWidget(primaryViews_, 1);

    connect(section_, &trajectory_common::SectionBar::sectionRequested, this, &LongitudinalViews::sectionRequested);
    connect(table_, &SectionTable::sectionPicked, this, &LongitudinalViews::sectionRequested);
    connect(formOnly_, &QCheckBox::toggled, this, [this] {
        stacked_.reset();
        limit_um_.reset();
        showStack();
    });
    connect(scene_, &scene::SceneView::pointPicked, this,
            [this](int, qint64 point) { choose(static_cast<std::size_t>(point)); });
    connect(scene_, &scene::SceneView::surfaceHovered, this, [this](int, const scene::PickedPlace& on) {
        Eigen::Index corner = 0;
        on.weights.maxCoeff(&corner);
        const std::size_t vertex = on.corners[static_cast<std::size_t>(corner)];
        const auto deviation_um = static_cast<double>((*stack_.deviation_um)[vertex]);
        const double z_mm = outcome_->trajectory->sections[stack_.sectionOf(vertex)].z_mm;
        const QString turned = screenNumber(stack_.angle_deg(vertex), 0) + "°";
        scene_->setTag(
            screenQuantity(deviation_um, micrometre, 2, true),
            std::isfinite(z_mm) ? QString("z %1  ·  %2").arg(screenQuantity(z_mm, millimetre, 1), turned) : turned);
    });
    connect(scene_, &scene::SceneView::surfacePicked, this, [this](int, const scene::PickedPlace& on) {
        Eigen::Index corner = 0;
        on.weights.maxCoeff(&corner);
        choose(on.corners[static_cast<std::size_t>(corner)]);
    });
    connect(scene_, &scene::SceneView::limitEdited, this, [this](double upper_um, double lower_um) {
        limit_um_ = upper_um;
        report::DeviationColours colours{upper_um};
        if (lower_um > 0) colours.lower = lower_um;
        scene_->setColours(colours);
    });
    connect(profile_, &plot::PlotCanvas::clicked, this, [this](double z_mm, double) {
        const auto& sections = outcome_->trajectory->sections;
        const auto nearest = std::min_element(sections.begin(), sections.end(), [&](const auto& a, const auto& b) {
            return std::abs(a.z_mm - z_mm) < std::abs(b.z_mm - z_mm);
        });
        if (nearest != sections.end()) emit sectionRequested(nearest->section);
    });
    connect(profile_, &plot::PlotWidget::notWritten, this, &LongitudinalViews::notWritten);
    connect(&angle_, &trajectory_common::MarkedAngle::changed, this, &LongitudinalViews::markPlace);
    retranslate();
}

void LongitudinalViews::buildBar()
{
    auto* row = new FlowRow;
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    row->addWidget(section_);
    row->addWidget(angleBar_);
    row->addWidget(formOnly_);
    magnification_->setObjectName("magnification");
    magnification_->setRange(1, 100000);
    magnification_->setDecimals(0);
    magnification_->setKeyboardTracking(false);
    magnification_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    magnificationLabel_->setBuddy(magnification_);
    row->addWidget(magnificationLabel_);
    row->addWidget(magnification_);
    connect(magnification_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double times) {
        chosenMagnification_ = times;
        stacked_.reset();
        showStack();
    });
    synthetic_->setFrameShape(QFrame::Box);
    synthetic_->setMargin(2);
    synthetic_->hide();
    row->setTrailing(synthetic_);
}

void LongitudinalViews::setOutcome(const std::shared_ptr<const trajectory::TrajectoryOutcome>& outcome,
                                   bool sectionChosen)
{
    const bool news = !outcome_ || outcome_->trajectory != outcome->trajectory;
    outcome_ = outcome;
    section_->setSections(outcome->trajectory, outcome->section, sectionChosen);
    synthetic_->setVisible(outcome->sources.synthetic);
    if (news) {
        table_->setResult(*outcome->trajectory);
        const auto& along = outcome->trajectory->longitudinal;
        profile_->setData(along ? longitudinalPlot(*along, screenLanguage()) : report::Plot());
    }
    primaryViews_->setAvailable("profile", outcome->trajectory->longitudinal.has_value());
    showStack();
    markPlace();
}

void LongitudinalViews::showStack()
{
    if (!outcome_ || stacked_ == outcome_->trajectory) return;
    stacked_ = outcome_->trajectory;
    stack_ = trajectory::stackedSections(*stacked_, formOnly_->isChecked(), chosenMagnification_);
    scene_->setVisible(stack_.scan != nullptr);
    if (!stack_.scan) return;
    const QSignalBlocker quiet(magnification_);
    magnification_->setValue(stack_.magnification);
    scene::SceneObject surface;
    surface.name = tr("Surface of all sections");
    surface.scan = stack_.scan;
    surface.values = stack_.deviation_um;
    scene_->setLongAxis(scene::SceneAxis{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()});
    scene_->setColours({limit_um_.value_or(stack_.limit_um), {}});
    scene_->setObjects({surface});
    markPlace();
}

/// The section and the angle of a vertex of the surface.
void LongitudinalViews::choose(std::size_t vertex)
{
    angle_.set(stack_.angle_deg(vertex));
    const std::size_t index = stack_.sectionOf(vertex);
    if (index != outcome_->section) emit sectionRequested(outcome_->trajectory->sections[index].section);
}

void LongitudinalViews::markPlace()
{
    if (!outcome_ || !outcome_->section) return;
    const std::size_t index = *outcome_->section;
    const trajectory::TrajectorySection& section = outcome_->trajectory->sections[index];
    table_->markSection(index);
    profile_->setMarker(std::isfinite(section.z_mm) ? std::optional(section.z_mm) : std::nullopt);
    if (!stack_.scan || stacked_ != outcome_->trajectory) return;
    if (!angle_.angle_deg()) return scene_->setMarker({});
    const std::size_t vertex = stack_.vertexAt(index, *angle_.angle_deg());
    const double deviation_um = (*stack_.deviation_um)[vertex];
    scene_->setMarker(stack_.scan->points_mm[vertex], tr("section %1, angle %2°\ndeviation %3")
                                                          .arg(section.section)
                                                          .arg(screenNumber(*angle_.angle_deg(), 1),
                                                               screenQuantity(deviation_um, micrometre, 2, true)));
}

Values LongitudinalViews::view() const
{
    Values kept{{"form_only", formOnly_->isChecked()},
                {"magnification", chosenMagnification_ ? Value(*chosenMagnification_) : Value()}};
    if (std::vector<double> camera = scene_->view(); !camera.empty()) kept.emplace_back("camera", std::move(camera));
    return kept;
}

void LongitudinalViews::restoreView(const Values& kept)
{
    const QSignalBlocker quiet(formOnly_);
    const Value* const form_only = lathelier::find(kept, "form_only");
    formOnly_->setChecked(form_only && *form_only == Value(true));
    const Value* const times = lathelier::find(kept, "magnification");
    const auto* const given = times ? std::get_if<double>(times) : nullptr;
    chosenMagnification_ = given && *given >= 1 ? std::optional(*given) : std::nullopt;
    if (const Value* camera = lathelier::find(kept, "camera"))
        if (const auto* numbers = std::get_if<std::vector<double>>(camera)) scene_->setView(*numbers);
    stacked_.reset();
    showStack();
}

std::vector<report::Picture> LongitudinalViews::pictures()
{
    std::vector<report::Picture> pictures;
    if (!stack_.scan || !scene_->canDraw()) return pictures;
    const QImage image = scene_->paperPicture(scene::SceneViewpoint::Oblique);
    if (image.isNull()) return pictures;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    pictures.push_back({LT_TEXT("Engine", "Surface of all sections, deviations magnified"), bytes.toStdString()});
    return pictures;
}

void LongitudinalViews::retranslate()
{
    formOnly_->setText(tr("form only"));
    formOnly_->setToolTip(tr("Take out where each section lies and how large it is: what is left is its roundness"));
    magnificationLabel_->setText(tr("Error ×"));
    magnification_->setToolTip(tr("How many times larger the surface draws the deviation"));
    magnification_->setAccessibleName(magnification_->toolTip());
    synthetic_->setText(tr("Synthetic data"));
    primaryViews_->setTitle("stack", tr("Form"));
    primaryViews_->setTitle("profile", tr("Along the axis"));
    primaryViews_->setTitle("sections", tr("Sections"));
    scene_->setScale({LT_TEXT("Engine", "Deviation"), unit::um});
    if (!outcome_) return;
    const auto outcome = std::move(outcome_);
    outcome_.reset();
    stacked_.reset();
    setOutcome(outcome, !section_->isWorst());
}

}  // namespace lathelier::longitudinal_panel
