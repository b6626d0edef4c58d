// Where opened files go, with the panels of the program.
#include "app/gui/file_taker.h"

#include <QTest>

#include "app/gui/panels.h"
#include "engine/cad/step_kind.h"
#include "engine/gcode/program_kind.h"
#include "engine/io/image/image_kind.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle/spindle_kind.h"

namespace lathelier {

class FileTakerTest : public QObject {
    Q_OBJECT

    static FoundFile of(const io::FileKind& kind, const std::string& name = "file")
    {
        return {name, &kind, io::Likeness::Certain};
    }
    static std::vector<const PanelFacts*> table()
    {
        std::vector<const PanelFacts*> all;
        for (const PanelFacts& facts : panelTable()) all.push_back(&facts);
        return all;
    }
    /// The panels that take the files, with `active` in front.
    static QStringList takers(const std::vector<FoundFile>& files, const std::string& active,
                              const project::Project& project = {})
    {
        std::optional<std::size_t> index;
        for (std::size_t i = 0; i < panelTable().size(); ++i)
            if (panelTable()[i].id == active) index = i;
        QStringList ids;
        for (const Opening& opening : openingsOf(files, table(), index, project))
            for (std::size_t i = 0; i < opening.files.size(); ++i)
                ids << QString::fromStdString(panelTable()[opening.panel].id);
        return ids;
    }
    static project::Project with(const std::string& panel, const std::vector<std::string>& roles)
    {
        project::Project project;
        for (const std::string& role : roles) project.panels[panel].inputs[role].path = "/given";
        return project;
    }

private slots:
    void oneAloneGoesWhereItIsDrawnAtOnce()
    {
        QCOMPARE(takers({of(io::scanFiles())}, "compare"), QStringList{"recognise"});
        QCOMPARE(takers({of(io::scanFiles())}, "roundness"), QStringList{"recognise"});
        QCOMPARE(takers({of(io::scanFiles())}, "drawing", with("drawing", {"shaft"})), QStringList{"recognise"});
        QCOMPARE(takers({of(io::scanFiles())}, ""), QStringList{"recognise"});
        QCOMPARE(takers({of(cad::stepFiles())}, "compare"), QStringList{"drawing"});
        QCOMPARE(takers({of(io::shaftFiles())}, "roundness"), QStringList{"drawing"});
        QCOMPARE(takers({of(io::probeRecordFiles())}, "compare"), QStringList{"roundness"});
        QCOMPARE(takers({of(io::profileFiles())}, "lobes"), QStringList{"roundness"});
        QCOMPARE(takers({of(io::frfFiles())}, "compare"), QStringList{"frf"});
        QCOMPARE(takers({of(gcode::programFiles())}, "compare"), QStringList{"program"});
        QCOMPARE(takers({of(io::imageFiles())}, "compare"), QStringList{"surface"});
    }

    void thePanelInFrontKeepsWhatItWorksOn()
    {
        for (const std::vector<std::string>& given : {std::vector<std::string>{"reference"},
                                                      {"copy"},
                                                      {"reference", "copy"}})  // a free input, or the next part
            QCOMPARE(takers({of(io::scanFiles())}, "compare", with("compare", given)), QStringList{"compare"});
        QCOMPARE(takers({of(io::scanFiles())}, "roundness", with("compare", {"reference", "copy"})),
                 QStringList{"recognise"});
        QCOMPARE(takers({of(cad::stepFiles())}, "compare", with("compare", {"copy"})), QStringList{"compare"});
        QCOMPARE(takers({of(io::frfFiles())}, "lobes"), QStringList{"lobes"});
        QCOMPARE(takers({of(gcode::programFiles())}, "deflection"), QStringList{"deflection"});
        // In front by the user's choice, where the part has files already.
        for (const char* active : {"cylindricity", "compare"})
            QCOMPARE(takers({of(io::scanFiles())}, active, with("roundness", {"record"})), QStringList{active});
        QCOMPARE(takers({of(io::scanFiles())}, "cylindricity"), QStringList{"recognise"});
    }

    void thoseOpenedTogetherGoWhereAllFit()
    {
        const FoundFile scan = of(io::scanFiles()), step = of(cad::stepFiles()), shaft = of(io::shaftFiles());
        for (const char* active : {"compare", "recognise", "drawing", "roundness", ""}) {
            QCOMPARE(takers({step, scan}, active), QStringList({"compare", "compare"}));
            QCOMPARE(takers({scan, shaft}, active), QStringList({"compare", "compare"}));
            QCOMPARE(takers({scan, scan}, active), QStringList({"compare", "compare"}));
        }
        QCOMPARE(takers({of(gcode::programFiles()), of(receptance::spindleFiles())}, "deflection"),
                 QStringList({"deflection", "deflection"}));
        QCOMPARE(takers({scan, of(io::frfFiles())}, "compare"), QStringList({"recognise", "frf"}));  // no panel of both
        QCOMPARE(takers({}, "compare"), QStringList());
    }
};

}  // namespace lathelier

QTEST_GUILESS_MAIN(lathelier::FileTakerTest)
#include "file_taker_test.moc"
