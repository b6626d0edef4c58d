#include "app/gui/shop_dialog.h"

#include <QComboBox>
#include <QDate>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "engine/cam/post/post.h"
#include "engine/cam/task/turn_question.h"
#include "engine/io/file.h"
#include "engine/io/input_files.h"
#include "widgets/core/form/form.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

using shop::ShopChoice;
using shop::ShopEntry;
using shop::ShopLibrary;
using shop::StatedShop;

/// One table of the shop: which entry is used, and its values. An entry that is built in becomes an own one when it is
/// changed.
template <class T>
class ShopPage : public QWidget {
public:
    ShopPage(StatedShop& shop, std::vector<ShopEntry<T>> ShopLibrary::*list, std::string ShopChoice::*choice,
             const char* name, bool may_be_none)
        : shop_(shop),
          list_(list),
          choice_(choice),
          mayBeNone_(may_be_none),
          entries_(new QComboBox),
          form_(new Form(infos<T>())),
          source_(new QLineEdit),
          remove_(new QPushButton(ShopDialog::tr("Remove")))
    {
        setObjectName(QString("page_") + name);
        entries_->setObjectName(QString("entry_") + name);
        source_->setObjectName(QString("source_") + name);
        auto* add = new QPushButton(ShopDialog::tr("New"));
        add->setToolTip(ShopDialog::tr("An entry of your own, with the values of this one"));
        remove_->setToolTip(ShopDialog::tr("Takes your own entry away; one that is built in stays"));
        auto* head = new QHBoxLayout;
        head->addWidget(entries_, 1);
        head->addWidget(add);
        head->addWidget(remove_);
        auto* origin = new QFormLayout;
        origin->addRow(ShopDialog::tr("Source"), source_);
        auto* scroll = new QScrollArea;
        scroll->setWidgetResizable(true);
        scroll->setFrameShape(QFrame::NoFrame);
        scroll->setWidget(form_);
        auto* layout = new QVBoxLayout(this);
        layout->addLayout(head);
        layout->addLayout(origin);
        layout->addWidget(scroll, 1);
        QObject::connect(entries_, qOverload<int>(&QComboBox::activated), this, [this](int at) {
            shop_.choice.*choice_ = entries_->itemData(at).toString().toStdString();
            fill();
        });
        QObject::connect(form_, &Form::valueChanged, this,
                         [this](const std::string& key, const Value& value, int) { change(key, value); });
        QObject::connect(source_, &QLineEdit::textEdited, this, [this](const QString& text) {
            if (ShopEntry<T>* const own = ownEntry()) own->source = text.toStdString();
        });
        QObject::connect(add, &QPushButton::clicked, this, [this] { addEntry(); });
        QObject::connect(remove_, &QPushButton::clicked, this, [this] { removeEntry(); });
        fill();
    }

    void fill()
    {
        const std::vector<ShopEntry<T>> all = (shop::united(shop_.own, shop::shopLibrary())).*list_;
        std::string& key = shop_.choice.*choice_;
        const bool is_none = mayBeNone_ && key.empty();
        if (!is_none && !all.empty() && entryIn(all, key) == all.end()) key = all.front().key;
        entries_->clear();
        if (mayBeNone_) entries_->addItem(ShopDialog::tr("none"), QString());
        for (const ShopEntry<T>& entry : all) {
            const QString title = QString::fromStdString(entry.value.name.empty() ? entry.key : entry.value.name);
            entries_->addItem(entry.is_own ? title : ShopDialog::tr("%1 (built in, assumed)").arg(title),
                              QString::fromStdString(entry.key));
        }
        entries_->setCurrentIndex(entries_->findData(QString::fromStdString(key)));
        const auto shown = entryIn(all, key);
        const bool is_there = !is_none && shown != all.end();
        form_->setEnabled(is_there);
        source_->setEnabled(is_there);
        remove_->setEnabled(is_there && shown->is_own);
        source_->setText(is_there ? QString::fromStdString(shown->source) : QString());
        if (is_there) form_->setValues(toValues(shown->value));
    }

private:
    static auto entryIn(const std::vector<ShopEntry<T>>& entries, const std::string& key)
    {
        return std::find_if(entries.begin(), entries.end(),
                            [&](const ShopEntry<T>& entry) { return entry.key == key; });
    }

    /// The chosen entry as an own one; nullptr: none is chosen.
    ShopEntry<T>* ownEntry()
    {
        std::vector<ShopEntry<T>>& own = shop_.own.*list_;
        const std::string& key = shop_.choice.*choice_;
        for (ShopEntry<T>& entry : own)
            if (entry.key == key) return &entry;
        const std::vector<ShopEntry<T>>& built_in = shop::shopLibrary().*list_;
        const auto found = entryIn(built_in, key);
        if (found == built_in.end()) return nullptr;
        own.push_back(*found);
        own.back().is_own = true;
        own.back().source =
            ShopDialog::tr("stated by the user, %1").arg(QDate::currentDate().toString(Qt::ISODate)).toStdString();
        return &own.back();
    }

    void change(const std::string& key, const Value& value)
    {
        ShopEntry<T>* const own = ownEntry();
        if (!own) return;
        Values values = toValues(own->value);
        set(values, key, value);
        try {
            own->value = fromValues<T>(values);
        } catch (const Error&) {  // half typed; the form keeps it
            return;
        }
        remove_->setEnabled(true);
        source_->setText(QString::fromStdString(own->source));
    }

    void addEntry()
    {
        ShopEntry<T>* const of = ownEntryOrFirst();
        if (!of) return;
        ShopEntry<T> made = *of;
        const std::vector<ShopEntry<T>> all = (shop::united(shop_.own, shop::shopLibrary())).*list_;
        int number = 1;
        do made.key = "own_" + std::to_string(number++);
        while (entryIn(all, made.key) != all.end());
        made.is_own = true;
        made.value.name = ShopDialog::tr("My %1").arg(QString::fromStdString(of->value.name)).toStdString();
        made.source =
            ShopDialog::tr("stated by the user, %1").arg(QDate::currentDate().toString(Qt::ISODate)).toStdString();
        (shop_.own.*list_).push_back(made);
        shop_.choice.*choice_ = made.key;
        fill();
    }

    /// A copy of the shown entry, without making that an own one.
    ShopEntry<T>* ownEntryOrFirst()
    {
        shown_ = {};
        const std::vector<ShopEntry<T>> all = (shop::united(shop_.own, shop::shopLibrary())).*list_;
        if (all.empty()) return nullptr;
        const auto found = entryIn(all, shop_.choice.*choice_);
        shown_ = found == all.end() ? all.front() : *found;
        return &shown_;
    }

    void removeEntry()
    {
        std::erase_if(shop_.own.*list_, [&](const ShopEntry<T>& entry) { return entry.key == shop_.choice.*choice_; });
        fill();
    }

    StatedShop& shop_;
    std::vector<ShopEntry<T>> ShopLibrary::*list_;
    std::string ShopChoice::*choice_;
    bool mayBeNone_;
    ShopEntry<T> shown_;
    QComboBox* entries_;
    Form* form_;
    QLineEdit* source_;
    QPushButton* remove_;
};

}  // namespace

ShopDialog::ShopDialog(const shop::StatedShop& stated, QWidget* parent)
    : QDialog(parent), shop_(stated), pages_(new QTabWidget), post_(new QComboBox)
{
    setObjectName("shopDialog");
    setWindowTitle(tr("Shop"));
    post_->setObjectName("shopPost");
    post_->addItem(tr("that of the lathe"), QString());
    for (const std::string& name : cam::postNames())
        post_->addItem(screenText(cam::labelOfPost(name)), QString::fromStdString(name));
    connect(post_, qOverload<int>(&QComboBox::activated), this,
            [this](int at) { shop_.choice.post = post_->itemData(at).toString().toStdString(); });
    auto* control = new QFormLayout;
    control->addRow(tr("Control"), post_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QPushButton* read_file = buttons->addButton(tr("Read…"), QDialogButtonBox::ActionRole);
    QPushButton* write_file = buttons->addButton(tr("Write…"), QDialogButtonBox::ActionRole);
    for (QPushButton* button : {read_file, write_file}) button->setAutoDefault(false);
    connect(read_file, &QPushButton::clicked, this, &ShopDialog::askToRead);
    connect(write_file, &QPushButton::clicked, this, &ShopDialog::askToWrite);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(control);
    layout->addWidget(pages_, 1);
    layout->addWidget(buttons);
    fill();
    resize(fontMetrics().averageCharWidth() * 90, fontMetrics().height() * 34);
}

void ShopDialog::fill()
{
    const int shown = pages_->currentIndex();
    while (pages_->count() > 0) {
        QWidget* page = pages_->widget(0);
        pages_->removeTab(0);
        delete page;
    }
    post_->setCurrentIndex(std::max(0, post_->findData(QString::fromStdString(shop_.choice.post))));
    pages_->addTab(new ShopPage<shop::Lathe>(shop_, &ShopLibrary::lathes, &ShopChoice::lathe, "lathe", false),
                   tr("Lathe"));
    pages_->addTab(new ShopPage<shop::Chuck>(shop_, &ShopLibrary::chucks, &ShopChoice::chuck, "chuck", false),
                   tr("Chuck"));
    pages_->addTab(
        new ShopPage<shop::Tailstock>(shop_, &ShopLibrary::tailstocks, &ShopChoice::tailstock, "tailstock", true),
        tr("Tailstock"));
    pages_->addTab(new ShopPage<shop::ToolSet>(shop_, &ShopLibrary::tool_sets, &ShopChoice::tools, "tools", false),
                   tr("Tools"));
    pages_->addTab(
        new ShopPage<shop::BarMaterial>(shop_, &ShopLibrary::materials, &ShopChoice::material, "material", false),
        tr("Material"));
    pages_->setCurrentIndex(std::max(0, shown));
}

void ShopDialog::read(const QString& path)
{
    try {
        const io::FileBytes bytes(path.toStdString());
        Notes notes;
        shop_ = shop::readShop(std::string(bytes.view()), notes);
    } catch (Error& error) {
        error.with("path", path.toStdString());
        QMessageBox::warning(this, windowTitle(), screenText(error));
        return;
    }
    fill();
}

void ShopDialog::askToRead()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Read a shop"), {}, tr("Shops (*.json)"));
    if (!path.isEmpty()) read(path);
}

void ShopDialog::askToWrite()
{
    QFileDialog dialog(this, tr("Write the shop"), {}, tr("Shops (*.json)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("json");
    if (dialog.exec() != QDialog::Accepted) return;
    try {
        io::writeFile(dialog.selectedFiles().value(0).toStdString(), shop::shopText(shop_));
    } catch (const Error& error) {
        QMessageBox::warning(this, windowTitle(), screenText(error));
    }
}

}  // namespace lathelier
