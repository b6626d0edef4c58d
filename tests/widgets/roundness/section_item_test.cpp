// A section that another panel cut out of its data, judged by the roundness panel.
#include <QLocale>
#include <QTest>
#include <cmath>
#include <numbers>

#include "engine/core/profile_item.h"
#include "engine/project/project_codes.h"
#include "widgets/core/resources.h"
#include "widgets/core/session.h"
#include "widgets/roundness/roundness_panel.h"

namespace lathelier {

class SectionItemTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
    }

    void isJudgedAndNamedInTheReport()
    {
        Session session;
        roundness_panel::RoundnessPanel panel(session);
        Profile oval;
        oval.name = "part.ply, z 60 mm";
        for (int i = 0; i < 360; ++i) {
            const double angle = 2 * std::numbers::pi * i / 360, r = 20 + 0.005 * std::cos(2 * angle);
            oval.points_mm.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        session.edit("use", [&](project::Project& project) {
            project.items[oval.name] = {profileItem, toValues(oval), {}};
            project.panels["roundness"].inputs["profile"].item = oval.name;
        });
        QTRY_VERIFY_WITH_TIMEOUT(panel.isCurrent() || panel.error(), 20000);
        QVERIFY2(!panel.error(), panel.error() ? panel.error()->what() : "");
        QVERIFY(std::abs(panel.result()->judged().circles.MZCI.RONt_um - 10) < 0.01);
        const auto document = panel.reportDocument();
        QCOMPARE(document->inputs.size(), std::size_t{1});
        QCOMPARE(document->inputs[0].path, oval.name);
        QCOMPARE(document->inputs[0].sha256.size(), std::size_t{64});
    }

    void anItemThatIsGoneIsNamed()
    {
        Session session;
        roundness_panel::RoundnessPanel panel(session);
        session.edit("use",
                     [](project::Project& project) { project.panels["roundness"].inputs["profile"].item = "gone"; });
        QTRY_VERIFY_WITH_TIMEOUT(panel.error(), 20000);
        QVERIFY(panel.error()->code() == errors::itemNotThere);
    }
};

}  // namespace lathelier

QTEST_MAIN(lathelier::SectionItemTest)
#include "section_item_test.moc"
