// The real panel table and verb table together: what a new room has to bring is there, and nothing collides.
#include <QFile>
#include <QSet>
#include <QTest>

#include "app/cli/verb.h"
#include "app/gui/panels.h"
#include "app/gui/questions.h"
#include "widgets/core/resources.h"

namespace lathelier {

class RoomsTest : public QObject {
    Q_OBJECT

    static bool isNew(QSet<QString>& seen, const std::string& name)
    {
        const QString word = QString::fromStdString(name);
        if (seen.contains(word)) return false;
        seen.insert(word);
        return true;
    }

private slots:
    void initTestCase() { useResources(); }

    void panelsAreToldApart()
    {
        QSet<QString> ids, titles;
        for (const PanelFacts& panel : panelTable()) {
            QVERIFY2(isNew(ids, panel.id), panel.id.c_str());
            QVERIFY2(isNew(titles, panel.title.english), panel.title.english);
            QVERIFY(panel.make && panel.report);
            QVERIFY2(!panel.kinds.empty(), panel.id.c_str());
        }
    }

    void theReadmeNamesThePanels()
    {
        QFile file(LATHELIER_SOURCE_DIR "/README.md");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString readme = QString::fromUtf8(file.readAll());
        for (const PanelFacts& panel : panelTable())
            QVERIFY2(readme.contains("*" + QString(panel.title.english) + "*"), panel.title.english);
    }

    void everyPanelHasIconAndQuestion()
    {
        const auto hasIcon = [](const QString& name) { return QFile::exists(":/icons/" + name + ".svg"); };
        QSet<QString> icons;
        for (const PanelFacts& panel : panelTable()) QVERIFY2(hasIcon(panel.icon), qPrintable(panel.icon));
        for (const Question& question : questionsOf(panelTable())) {
            QVERIFY2(hasIcon(question.icon), question.id.c_str());
            QVERIFY2(isNew(icons, question.icon.toStdString()), question.id.c_str());
        }
    }

    /// As the house has it: docs of the look, "Questions and their panels".
    void panelsStandUnderTheirQuestions()
    {
        const std::vector<std::pair<std::string, std::vector<std::string>>> wanted{
            {"scan", {"recognise"}},
            {"drawing", {"drawing"}},
            {"machine", {"shaft", "spindle", "tap", "frf"}},
            {"speed", {"lobes", "pass", "speed"}},
            {"program", {"turning", "program"}},
            {"deflection", {"deflection", "correction"}},
            {"copy", {"compare"}},
            {"proof", {"chain"}},
            {"roundness", {"roundness", "trajectory", "longitudinal", "cylindricity"}},
            {"photographs", {"surface"}},
            {"training", {"training"}},
            {"series", {"series"}}};
        std::vector<std::pair<std::string, std::vector<std::string>>> found;
        for (const Question& question : questionsOf(panelTable())) {
            found.push_back({question.id, {}});
            for (const PanelFacts& panel : panelTable())
                if (panel.question.id == question.id) found.back().second.push_back(panel.id);
        }
        QVERIFY(found == wanted);
    }

    void verbsAndTheirOptionsAreToldApart()
    {
        QSet<QString> names;
        for (const cli::Verb& verb : cli::verbs()) {
            QVERIFY2(isNew(names, verb.name), verb.name.c_str());
            QVERIFY(verb.run && !verb.summary.empty() &&
                    !verb.operands.empty() == (verb.name != "verify" && verb.name != "assist"));
            QSet<QString> options;
            for (const cli::Option& option : verb.parameters)
                QVERIFY2(isNew(options, option.info.key), option.info.key.c_str());
            for (const cli::Option& option : cli::readingOptions(verb))
                QVERIFY2(isNew(options, option.info.key), option.info.key.c_str());
        }
    }

    void kindsOfFileAreToldApart()
    {
        io::FileKinds kinds;
        for (const PanelFacts& panel : panelTable()) io::unite(kinds, panel.kinds);
        for (const cli::Verb& verb : cli::verbs()) io::unite(kinds, verb.kinds);
        QSet<QString> keys, names;
        for (const io::FileKind* kind : kinds) {
            QVERIFY2(isNew(keys, kind->key), kind->key.c_str());
            QVERIFY2(isNew(names, kind->name.english), kind->key.c_str());
            QVERIFY(kind->sniff && kind->facts && !kind->patterns.empty());
            for (const FieldInfo& info : kind->reading) QVERIFY(find(kind->reading_defaults, info.key));
        }
        QVERIFY(keys.size() >= 4);
    }
};

}  // namespace lathelier

QTEST_GUILESS_MAIN(lathelier::RoomsTest)
#include "rooms_test.moc"
