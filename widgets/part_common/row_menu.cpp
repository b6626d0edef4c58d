#include "widgets/part_common/row_menu.h"

#include <QCoreApplication>

namespace lathelier::part_common {
namespace {

struct RowMenu {
    Q_DECLARE_TR_FUNCTIONS(lathelier::part_common::RowMenu)
};

void add(QMenu& menu, const QString& text, const QKeySequence& key, const std::function<void()>& act)
{
    QAction* const action = menu.addAction(text);
    action->setShortcut(key);
    action->setEnabled(static_cast<bool>(act));
    if (act) QObject::connect(action, &QAction::triggered, &menu, act);
}

}  // namespace

std::optional<RowForm> formOf(const ShaftSegment& row)
{
    if (row.arc_radius_mm) return *row.arc_radius_mm > 0 ? RowForm::Round : RowForm::Fillet;
    if (row.role == "groove") return RowForm::Groove;
    if (isCylinder(row)) return RowForm::Cylinder;
    return row.role == "chamfer" ? RowForm::Chamfer : RowForm::Cone;
}

QString formName(RowForm form)
{
    switch (form) {
        case RowForm::Cylinder: return RowMenu::tr("Cylinder");
        case RowForm::Cone: return RowMenu::tr("Cone");
        case RowForm::Chamfer: return RowMenu::tr("Chamfer");
        case RowForm::Round: return RowMenu::tr("Round");
        case RowForm::Fillet: return RowMenu::tr("Fillet");
        case RowForm::Groove: return RowMenu::tr("Groove");
    }
    return {};
}

void addRowVerbs(QMenu& menu, int number, const RowVerbs& verbs)
{
    menu.addSection(RowMenu::tr("Row %1").arg(number));
    add(menu, RowMenu::tr("Delete"), QKeySequence::Delete, verbs.remove);
    add(menu, RowMenu::tr("Merge with the next"), Qt::Key_M, verbs.merge);
    add(menu, RowMenu::tr("Split here"), Qt::Key_S, verbs.split);
    QMenu* const kinds = menu.addMenu(RowMenu::tr("Change its kind"));
    kinds->setEnabled(verbs.change != nullptr);
    for (const RowForm form : verbs.forms) {
        QAction* const action = kinds->addAction(formName(form));
        action->setCheckable(true);
        action->setChecked(verbs.now == form);
        action->setEnabled(verbs.now != form);
        QObject::connect(action, &QAction::triggered, kinds, [change = verbs.change, form] { change(form); });
    }
    if (!verbs.ties.empty()) {
        QMenu* const ties = menu.addMenu(RowMenu::tr("Same diameter as"));
        for (const auto& [name, act] : verbs.ties) add(*ties, name, {}, act);
    }
    if (verbs.untie) add(menu, RowMenu::tr("Free its diameter"), {}, verbs.untie);
}

bool pressRowKey(const QKeyEvent& event, const RowVerbs& verbs)
{
    if (event.modifiers() != Qt::NoModifier && event.modifiers() != Qt::KeypadModifier) return false;
    const std::function<void()>* verb = nullptr;
    switch (event.key()) {
        case Qt::Key_Delete: verb = &verbs.remove; break;
        case Qt::Key_M: verb = &verbs.merge; break;
        case Qt::Key_S: verb = &verbs.split; break;
        default: return false;
    }
    if (*verb) (*verb)();
    return true;
}

}  // namespace lathelier::part_common
