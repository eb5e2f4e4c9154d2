// SPDX-License-Identifier: GPL-3.0-or-later
// A whole gauge study through the page, by click and key; in its middle the process is killed.
#include "tests/support/test_registry.h"
#include "tests/ui/studying.h"

#include <QProcess>

#include <csignal>
#include <unistd.h>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::unhurriedA;
using gripscope::test::WindowFixture;
using namespace gripscope::test::studying;

namespace {

/// 10 parts, 3 operators, 3 trials with GRIPSCOPE_WHOLE_STUDY=1, which takes minutes; else a small one.
struct KilledDesign {
    int parts = 3, trials = 2;
    QString people = u"Anna, Ben"_s;
    std::size_t killedAfter = 5, squeezes = 12;
};

KilledDesign killedDesign()
{
    return qEnvironmentVariableIntValue("GRIPSCOPE_WHOLE_STUDY") > 0
               ? KilledDesign{10, 3, u"Anna, Ben, Cem"_s, 44, 90}
               : KilledDesign();
}

constexpr auto libraryOfTheKilled = "GRIPSCOPE_KILLED_LIBRARY";

} // namespace

class QualityKilledTest : public QObject {
    Q_OBJECT
private slots:
    /// Does nothing but in the process that the next one starts, and never ends there by itself.
    void theOneThatIsKilled()
    {
        const QString file = qEnvironmentVariable(libraryOfTheKilled);
        if (file.isEmpty())
            return;
        WindowFixture f(false, unhurriedA);
        startAgainOn(f, file);
        const KilledDesign design = killedDesign();
        beginStudy(f, design.parts, design.people, design.trials);
        while (study(f).progress().done < design.killedAfter && !QTest::currentTestFailed())
            squeezeNext(f);
        putIn(f, study(f).study()->plan.rows[*study(f).nextRow()]);
        pressSpaceOn(f, "studyAct");
        if (!QTest::currentTestFailed() && study(f).state() != State::Waiting)
            ::kill(::getpid(), SIGKILL); // in the middle of a squeeze
    }
    void aStudyOfAProcessThatWasKilledIsGoneOnWith()
    {
        const KilledDesign design = killedDesign();
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"killed.gripscope"_s);
        QProcess killed;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QString::fromLatin1(libraryOfTheKilled), file);
        killed.setProcessEnvironment(environment);
        killed.setProcessChannelMode(QProcess::MergedChannels);
        killed.start(QCoreApplication::applicationFilePath(),
                     {u"QualityKilledTest"_s, u"theOneThatIsKilled"_s});
        QVERIFY(killed.waitForFinished(15 * 60 * 1000));
        const QByteArray told = killed.readAll();
        QVERIFY2(killed.exitStatus() == QProcess::CrashExit, told.constData());

        WindowFixture f(false, unhurriedA);
        startAgainOn(f, file);
        goOnWithStudy(f);
        QCOMPARE(study(f).progress().done, design.killedAfter); // all but the one under way
        QCOMPARE(study(f).progress().rows.size(), design.squeezes);
        QVERIFY(study(f).study()->plan == makePlan(study(f).study()->plan.design).value());
        while (study(f).nextRow() && !QTest::currentTestFailed())
            squeezeNext(f);
        pressSpaceOn(f, "studyAct");
        const QString verdict = shownVerdict(f);
        QVERIFY2(verdict.contains(u"kinds of"_s), qPrintable(verdict));
        const GaugeResult* const gauge = (*study(f).result())->gauge();
        QVERIFY(gauge != nullptr && gauge->study.balanced);
        QCOMPARE(gauge->study.rows, Eigen::Index(design.squeezes));
        qInfo("%s", qPrintable(verdict));
    }
};

GRIPSCOPE_TEST(QualityKilledTest)
#include "quality_killed_test.moc"
