// SPDX-License-Identifier: GPL-3.0-or-later
// The tests of the tests: a class that fails is a failure whatever it skips, for our main, for ctest and for
// the look at a whole run (tests_ran.sh); and a test that vanished is missed.
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

using namespace Qt::StringLiterals;

namespace {

struct Ended {
    int status = -1;
    QString output; ///< both channels
};

Ended run(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    if (!process.waitForFinished(240'000) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAll())};
}

const QString outcomes = QStringLiteral(GRIPSCOPE_BIN_DIR "/outcomes");

/// A tree of sources with one test class each, and a build folder in which ctest runs `outcomes` under their
/// names.
class Tree {
public:
    explicit Tree(const QStringList& classes)
    {
        QDir(m_folder.path()).mkpath(u"tests/support"_s);
        QDir(m_folder.path()).mkpath(u"build/tests"_s);
        leaveOut({});
        allowSkips({});
        QFile::copy(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/tests/support/tests_ran.sh"),
                    m_folder.filePath(u"tests/support/tests_ran.sh"_s));
        addSource(u"Given"_s);
        registerTests(classes);
    }

    /// tests/core/given_test.cpp, registered with ctest under every class of `outcomes` that is named.
    void registerTests(const QStringList& classes) const
    {
        QString text;
        for (const QString& name : classes)
            text +=
                u"add_test(%1 \"%2\" %3)\nset_tests_properties(%1 PROPERTIES SKIP_RETURN_CODE 77)\n"_s.arg(
                    u"core."_s + (name == u"Passes"_s ? u"GivenTest"_s : name), outcomes, name);
        write(u"build/CTestTestfile.cmake"_s, text);
    }
    void addSource(const QString& name) const
    {
        QDir(m_folder.path()).mkpath(u"tests/core"_s);
        write(u"tests/core/%1_test.cpp"_s.arg(name.toLower()), u"GRIPSCOPE_TEST(%1Test)\n"_s.arg(name));
    }
    void leaveOut(const QString& lines) const { write(u"build/tests/left_out.txt"_s, lines); }
    void allowSkips(const QString& lines) const { write(u"tests/support/may_be_skipped.txt"_s, lines); }

    [[nodiscard]] Ended ctest() const
    {
        Ended ended = run(QStringLiteral(GRIPSCOPE_CTEST), {u"--test-dir"_s, m_folder.filePath(u"build"_s)});
        write(u"log"_s, ended.output);
        return ended;
    }
    /// What tests_ran.sh says of the last run.
    [[nodiscard]] Ended lookAtTheRun() const
    {
        return run(u"bash"_s, {m_folder.filePath(u"tests/support/tests_ran.sh"_s),
                               m_folder.filePath(u"build"_s), m_folder.filePath(u"log"_s)});
    }

private:
    void write(const QString& name, const QString& text) const
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text.toUtf8()) < 0)
            qFatal("cannot write %s", qPrintable(file.fileName()));
    }
    QTemporaryDir m_folder;
};

} // namespace

class OutcomeTest : public QObject {
    Q_OBJECT
private slots:
    void aClassEndsWithAStatusOfItsOwn_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("status");
        QTest::newRow("passes") << u"Passes"_s << 0;
        QTest::newRow("skips one function") << u"Skips"_s << 77;
        QTest::newRow("skips all") << u"SkipsAll"_s << 77;
        QTest::newRow("fails and skips") << u"FailsAndSkips"_s << 1;
        QTest::newRow("fails 77 times") << u"Fails77"_s << 1;
        QTest::newRow("fails 256 times") << u"Fails256"_s << 1;
        QTest::newRow("is not there") << u"NoSuchClass"_s << 1;
    }
    void aClassEndsWithAStatusOfItsOwn()
    {
        QFETCH(QString, name);
        QTEST(run(outcomes, {name}).status, "status");
    }

    void ctestFailsWhereAnyFunctionFailedWhateverWasSkipped_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("good");
        QTest::addColumn<QString>("word");
        QTest::newRow("passes") << u"Passes"_s << true << u"Passed"_s;
        QTest::newRow("skips") << u"Skips"_s << true << u"***Skipped"_s;
        QTest::newRow("fails and skips") << u"FailsAndSkips"_s << false << u"***Failed"_s;
        QTest::newRow("fails 77 times") << u"Fails77"_s << false << u"***Failed"_s;
    }
    void ctestFailsWhereAnyFunctionFailedWhateverWasSkipped()
    {
        QFETCH(QString, name);
        QFETCH(bool, good);
        QFETCH(QString, word);
        const Ended ended = Tree({name}).ctest();
        QVERIFY2((ended.status == 0) == good, qPrintable(ended.output));
        QVERIFY2(ended.output.contains(word), qPrintable(ended.output));
    }

    /// The real tests have what the ones above were given, and none looks for words in the output, since they
    /// would win over the status.
    void everyClassIsRegisteredThatWay()
    {
        const Ended listed =
            run(QStringLiteral(GRIPSCOPE_CTEST),
                {u"--test-dir"_s, QStringLiteral(GRIPSCOPE_BUILD_DIR), u"--show-only=json-v1"_s});
        const QJsonArray tests = QJsonDocument::fromJson(listed.output.toUtf8())[u"tests"].toArray();
        QVERIFY(tests.size() > 100);
        for (const auto& test : tests) {
            const QString name = test[u"name"].toString();
            for (const auto& property : test[u"properties"].toArray())
                QVERIFY2(!property[u"name"].toString().contains(u"REGULAR_EXPRESSION"_s), qPrintable(name));
        }
    }

    void aRunIsLookedAtAsAWhole()
    {
        Tree tree({u"Passes"_s});
        QCOMPARE(tree.ctest().status, 0);
        Ended look = tree.lookAtTheRun();
        QVERIFY2(look.status == 0, qPrintable(look.output));
        QVERIFY2(look.output.contains(u"1 tests, each accounted for"_s), qPrintable(look.output));

        tree.addSource(u"Vanished"_s);
        look = tree.lookAtTheRun();
        QCOMPARE(look.status, 1);
        QVERIFY2(look.output.contains(u"core.VanishedTest is not registered"_s), qPrintable(look.output));

        tree.leaveOut(u"cor no folder of ours\n"_s);
        QCOMPARE(tree.lookAtTheRun().status, 1);
        tree.leaveOut(u"core this build has no core\n"_s);
        look = tree.lookAtTheRun();
        QVERIFY2(look.status == 0, qPrintable(look.output));
    }

    void aSkipIsForgivenOnlyWhereItIsAllowed()
    {
        const Tree tree({u"Passes"_s, u"Skips"_s});
        QCOMPARE(tree.ctest().status, 0); // ctest itself is content
        Ended look = tree.lookAtTheRun();
        QCOMPARE(look.status, 1);
        QVERIFY2(look.output.contains(u"core.Skips was skipped"_s), qPrintable(look.output));

        tree.allowSkips(u"core.Skips without:nowhere/to/be/found they are not ours\n"_s);
        look = tree.lookAtTheRun();
        QVERIFY2(look.status == 0, qPrintable(look.output));
        QVERIFY2(look.output.contains(u"skipped: core.Skips (they are not ours)"_s), qPrintable(look.output));
        tree.allowSkips(u"core.Skips without:tests they are not ours\n"_s); // but they are there
        QCOMPARE(tree.lookAtTheRun().status, 1);
        tree.allowSkips(u"core.Skips with:tests it is in the way\n"_s);
        QCOMPARE(tree.lookAtTheRun().status, 0);
    }

    void whatFailedOrDidNotRunIsNamed()
    {
        Tree tree({u"Passes"_s, u"FailsAndSkips"_s});
        (void)tree.ctest();
        Ended look = tree.lookAtTheRun();
        QCOMPARE(look.status, 1);
        QVERIFY2(look.output.contains(u"core.FailsAndSkips: Failed"_s), qPrintable(look.output));

        tree.registerTests({u"Passes"_s});
        (void)tree.ctest();
        tree.registerTests({u"Passes"_s, u"Skips"_s}); // since then
        look = tree.lookAtTheRun();
        QCOMPARE(look.status, 1);
        QVERIFY2(look.output.contains(u"core.Skips did not run"_s), qPrintable(look.output));
    }

    void aTestWhosePackageIsMissingFailsAndNamesIt()
    {
        const Ended ended =
            run(u"cmake"_s, {u"-DPACKAGES=xvfb xauth"_s, u"-P"_s,
                             QStringLiteral(GRIPSCOPE_SOURCE_DIR "/tests/support/missing_packages.cmake")});
        QVERIFY(ended.status > 0);
        QVERIFY2(ended.output.simplified().contains(u"xvfb xauth"_s), qPrintable(ended.output));
    }
};

GRIPSCOPE_TEST(OutcomeTest)
#include "outcome_test.moc"
