#include "widgets/core/form/input_column.h"

#include <QCollator>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/core/form/form.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {

InputColumn::InputColumn(const PanelInputs& inputs, QWidget* parent)
    : QScrollArea(parent), inputs_(inputs), add_(new QToolButton), form_(new Form(inputs.fields))
{
    setObjectName("inputColumn");
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setSpacing(12);
    for (const InputRole& role : inputs.roles) layout->addWidget(makeBox(role));
    add_->setObjectName("addInput");
    add_->setIcon(icon("add"));
    add_->setAutoRaise(true);
    add_->setFocusPolicy(Qt::StrongFocus);
    add_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    add_->setPopupMode(QToolButton::InstantPopup);
    add_->setMenu(new QMenu(add_));
    add_->menu()->setToolTipsVisible(true);
    connect(add_->menu(), &QMenu::aboutToShow, this, &InputColumn::fillAddMenu);
    layout->addWidget(add_, 0, Qt::AlignLeft);
    auto* line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    layout->addWidget(line);
    form_->setValues(inputs.defaults);
    layout->addWidget(form_);
    layout->addStretch();
    retranslate();
    showPlaces();
    setWidget(column);  // its layout requests are handled in eventFilter()
    connect(form_, &Form::valueChanged, this, [this](const std::string& key, const Value& value, int gesture) {
        const auto info = std::find_if(inputs_.fields.begin(), inputs_.fields.end(),
                                       [&](const FieldInfo& field) { return field.key == key; });
        emit parameterEdited(key, value, gesture, tr("Change: %1").arg(screenText(info->label)));
    });
}

bool InputColumn::eventFilter(QObject* watched, QEvent* event)
{
    // There is no horizontal scroll bar: the column is at least as wide as its content, in any language and font size.
    if (watched == widget() && (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize))
        setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
    return QScrollArea::eventFilter(watched, event);
}

InputBox* InputColumn::makeBox(const InputRole& role)
{
    auto* box = new InputBox(role);
    boxes_[role.role] = box;
    connect(box, &InputBox::openRequested, this, [this, role] { ask(role); });
    connect(box, &InputBox::filesDropped, this, [this, role](const QStringList& paths) { choose(role, paths); });
    connect(box, &InputBox::itemRequested, this, [this, role](const QString& name) { use(role, name); });
    connect(box, &InputBox::clearRequested, this,
            [this, role] { emit sourcesChosen(role, {}, tr("Take away: %1").arg(screenText(role.label))); });
    connect(box, &InputBox::importChanged, this, [this, role](const Values& import) {
        std::vector<project::Source> sources = sourcesOf(state_, role);
        for (project::Source& source : sources) source.import = import;
        if (!sources.empty())
            emit sourcesChosen(role, sources, tr("Change how to read: %1").arg(screenText(role.label)));
    });
    return box;
}

void InputColumn::use(const InputRole& role, const QString& item)
{
    project::Source source;
    source.item = item.toStdString();
    emit sourcesChosen(role, {source}, tr("Use “%1”").arg(item));
}

/// Of a panel without such inputs the first one has.
bool InputColumn::hasPlace(const InputRole& role) const
{
    const auto stands = [](const InputRole& one) { return one.required || one.takes_next; };
    if (stands(role) || state_.inputs.count(role.role) > 0) return true;
    return role.role == inputs_.roles.front().role && std::none_of(inputs_.roles.begin(), inputs_.roles.end(), stands);
}

void InputColumn::showPlaces()
{
    bool all = true;
    for (const InputRole& role : inputs_.roles) {
        boxes_.at(role.role)->setVisible(hasPlace(role));
        all = all && hasPlace(role);
    }
    add_->setVisible(!all);
    for (const auto& [key, role] : inputs_.tables) {
        const Value* const table = lathelier::find(state_.parameters, key);
        const auto* const rows = table ? std::get_if<Rows>(table) : nullptr;
        form_->setShown(key, state_.inputs.count(role) == 0 || (rows && !rows->rows.empty()));
    }
}

/// The inputs without a place: from a file, or what other panels made.
void InputColumn::fillAddMenu()
{
    QMenu* menu = add_->menu();
    menu->clear();
    for (const InputRole& role : inputs_.roles) {
        if (hasPlace(role)) continue;
        const QStringList items = items_[role.role];
        const QString label = screenText(role.label);
        QAction* action = nullptr;
        if (items.isEmpty()) {
            action = menu->addAction(tr("%1…").arg(label), this, [this, role] { ask(role); });
        } else {
            QMenu* from = menu->addMenu(label);
            for (const QString& item : items) from->addAction(item, this, [this, role, item] { use(role, item); });
            from->addSeparator();
            from->addAction(tr("Open a file…"), this, [this, role] { ask(role); });
            action = from->menuAction();
        }
        action->setObjectName(QString::fromStdString("add_" + role.role));
        action->setToolTip(screenText(role.hint));
    }
}

void InputColumn::retranslate()
{
    add_->setText(tr("Add…"));
    add_->setToolTip(tr("Add what this panel can use besides: a file, or what another panel made"));
    add_->setAccessibleName(tr("Add an input"));
}

void InputColumn::changeEvent(QEvent* event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

void InputColumn::insertBefore(const std::string& role, QWidget* control)
{
    auto* layout = static_cast<QVBoxLayout*>(widget()->layout());
    layout->insertWidget(layout->indexOf(boxes_.at(role)), control, 0, Qt::AlignHCenter);
}

void InputColumn::ask(const InputRole& role)
{
    const QString title = tr("Open: %1").arg(screenText(role.label));
    const QString filter = fileFilter(role.kinds);
    QStringList paths;
    if (role.several)
        paths = QFileDialog::getOpenFileNames(this, title, {}, filter);
    else
        paths << QFileDialog::getOpenFileName(this, title, {}, filter);
    paths.removeAll(QString());
    if (!paths.isEmpty()) choose(role, paths);
}

void InputColumn::choose(const InputRole& role, const QStringList& paths)
{
    emit filesChosen(role, counted(paths));
}

void InputColumn::showState(const project::PanelState& state)
{
    state_ = state;
    form_->setValues(state.parameters);
    for (const InputRole& role : inputs_.roles) boxes_.at(role.role)->setSources(sourcesOf(state, role));
    showPlaces();
}

void InputColumn::showItems(const project::Project& project)
{
    for (const InputRole& role : inputs_.roles) {
        if (role.item_kind.empty()) continue;
        std::vector<InputBox::ItemOffer> offers;
        for (const auto& [name, item] : project.items)
            if (item.kind == role.item_kind)
                offers.push_back({QString::fromStdString(name), QString::fromStdString(item.origin.panel),
                                  project::isOutdated(project, item)});
        boxes_.at(role.role)->setItems(offers);
        QStringList& names = items_[role.role];
        names.clear();
        for (const InputBox::ItemOffer& offer : offers) names << offer.name;
    }
}

void InputColumn::showTaken(const std::vector<walk::Taken>& taken)
{
    for (const InputRole& role : inputs_.roles) {
        const auto found =
            std::find_if(taken.begin(), taken.end(), [&](const walk::Taken& one) { return one.role == role.role; });
        boxes_.at(role.role)->setTaken(found == taken.end() ? nullptr : &*found);
    }
}

void InputColumn::showFacts(const Understood& understood, const std::optional<Error>& error)
{
    const Value* path = error ? lathelier::find(error->values(), "path") : nullptr;
    for (const InputRole& role : inputs_.roles) {
        const std::vector<project::Source> sources = sourcesOf(state_, role);
        InputBox* box = boxes_.at(role.role);
        box->setUnderstood(sources.empty() ? QString() : understood(role, sources.front()));
        const bool meant = path && std::any_of(sources.begin(), sources.end(), [&](const project::Source& source) {
                               return *path == Value(source.path);
                           });
        box->setProblem(meant ? &*error : nullptr);
    }
}

project::Source newSource(const QString& path)
{
    project::Source source;
    source.path = QFileInfo(path).absoluteFilePath().toStdString();
    return source;
}

QString fileFilter(const io::FileKinds& kinds)
{
    QStringList filters, names, patterns;
    for (const io::FileKind* kind : kinds) {
        names << screenText(kind->name);
        patterns << QString::fromStdString(kind->patterns).split(' ');
        filters << QStringLiteral("%1 (%2)").arg(names.back(), QString::fromStdString(kind->patterns));
    }
    patterns.removeDuplicates();
    if (kinds.size() > 1) filters.prepend(QStringLiteral("%1 (%2)").arg(names.join(", "), patterns.join(' ')));
    filters << InputColumn::tr("All files (*)");
    return filters.join(";;");
}

QStringList counted(QStringList paths)
{
    QCollator order;
    order.setNumericMode(true);
    std::sort(paths.begin(), paths.end(), order);
    return paths;
}

}  // namespace lathelier
