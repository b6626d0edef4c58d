#include "widgets/core/input_column.h"

#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/core/form.h"
#include "widgets/core/input_box.h"
#include "widgets/core/language.h"

namespace lathelier {

InputColumn::InputColumn(const PanelInputs& inputs, QWidget* parent)
    : QScrollArea(parent), inputs_(inputs), form_(new Form(inputs.fields))
{
    setObjectName("inputColumn");
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setSpacing(12);
    for (const InputRole& role : inputs.roles) layout->addWidget(makeBox(role));
    auto* line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    layout->addWidget(line);
    form_->setValues(inputs.defaults);
    layout->addWidget(form_);
    layout->addStretch();
    setWidget(column);  // whose layout requests come to eventFilter() from now on
    connect(form_, &Form::valueChanged, this, [this](const std::string& key, const Value& value, int gesture) {
        const auto info = std::find_if(inputs_.fields.begin(), inputs_.fields.end(),
                                       [&](const FieldInfo& field) { return field.key == key; });
        emit parameterEdited(key, value, gesture, tr("Change: %1").arg(screenText(info->label)));
    });
}

bool InputColumn::eventFilter(QObject* watched, QEvent* event)
{
    // There is no horizontal scroll bar: the column is never narrower than what it holds, in any language and type
    // size.
    if (watched == widget() && (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize))
        setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
    return QScrollArea::eventFilter(watched, event);
}

InputBox* InputColumn::makeBox(const InputRole& role)
{
    auto* box = new InputBox(role);
    boxes_[role.role] = box;
    connect(box, &InputBox::openWanted, this, [this, role] { ask(role); });
    connect(box, &InputBox::fileDropped, this, [this, role](const QString& path) { choose(role, path); });
    connect(box, &InputBox::clearWanted, this, [this, role] {
        emit sourceChosen(role.role, std::nullopt, tr("Take away: %1").arg(screenText(role.label)));
    });
    connect(box, &InputBox::importChanged, this, [this, role](const Values& import) {
        const auto found = state_.inputs.find(role.role);
        if (found == state_.inputs.end()) return;
        Source source = found->second;
        source.import = import;
        emit sourceChosen(role.role, source, tr("Change how to read: %1").arg(screenText(role.label)));
    });
    return box;
}

void InputColumn::insertBefore(const std::string& role, QWidget* control)
{
    auto* layout = static_cast<QVBoxLayout*>(widget()->layout());
    layout->insertWidget(layout->indexOf(boxes_.at(role)), control, 0, Qt::AlignHCenter);
}

void InputColumn::ask(const InputRole& role)
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open: %1").arg(screenText(role.label)), {}, fileFilter(inputs_));
    if (!path.isEmpty()) choose(role, path);
}

void InputColumn::choose(const InputRole& role, const QString& path)
{
    emit sourceChosen(role.role, newSource(path), tr("Open %1").arg(QFileInfo(path).fileName()));
}

void InputColumn::showState(const PanelState& state)
{
    state_ = state;
    form_->setValues(state.parameters);
    for (const auto& [role, box] : boxes_) {
        const auto found = state.inputs.find(role);
        box->setSource(found == state.inputs.end() ? std::nullopt : std::optional(found->second));
    }
}

void InputColumn::showFacts(const ScanStore& scans, const std::optional<Error>& error)
{
    const Value* path = error ? lathelier::find(error->values(), "path") : nullptr;
    for (const auto& [role, box] : boxes_) {
        const auto found = state_.inputs.find(role);
        const bool there = found != state_.inputs.end();
        box->setUnderstood(there ? scans.known(found->second) : nullptr);
        box->setProblem(there && path && *path == Value(found->second.path) ? &*error : nullptr);
    }
}

Source newSource(const QString& path)
{
    Source source;
    source.path = QFileInfo(path).absoluteFilePath().toStdString();
    return source;
}

QString fileFilter(const PanelInputs& inputs)
{
    return InputColumn::tr("%1 (%2);;All files (*)").arg(screenText(inputs.files), inputs.patterns);
}

}  // namespace lathelier
