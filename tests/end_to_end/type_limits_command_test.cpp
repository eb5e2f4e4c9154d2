// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

/// `gripscope-cli types limits`, and what `classify` and `history` then say.
class TypeLimitsCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    ProgramRun limits(const QStringList& arguments) const
    {
        return m_work.cli(QStringList{u"types"_s, u"limits"_s, u"--library"_s, u"lib.db"_s, u"--type"_s,
                                      u"A"_s, u"--json"_s} +
                          arguments);
    }
    static QStringList because() { return {u"--reason"_s, u"drawing"_s, u"--operator"_s, u"Ada"_s}; }

private slots:
    void init()
    {
        QFile::remove(m_work.path(u"lib.db"_s));
        const auto library = Library::open(m_work.path(u"lib.db"_s));
        QVERIFY(library && (*library)->loadExampleTypes());
    }
    void setsShowsAndRemoves()
    {
        QVERIFY(limits({}).json()[u"rule"_s].isNull());
        const QJsonObject set =
            limits(QStringList{u"--k"_s, u"9000:11000"_s, u"--m"_s, u":0.05"_s} + because()).json();
        QCOMPARE(set[u"rule"_s].toString(), u"iso14253"_s);
        QCOMPARE(set[u"limits"_s][u"k"_s][u"upper"_s].toDouble(), 11000.0);
        QCOMPARE(set[u"limits"_s][u"k"_s][u"unit"_s].toString(), u"N/m"_s);
        QVERIFY(set[u"limits"_s][u"m"_s][u"lower"_s].isNull());
        QCOMPARE(limits({}).json(), set);
        // What is not named stays.
        const QJsonObject more =
            limits(QStringList{u"--rule"_s, u"risk"_s, u"--risk"_s, u"0.01"_s} + because()).json();
        QCOMPARE(more[u"risk"_s].toDouble(), 0.01);
        QCOMPARE(more[u"limits"_s], set[u"limits"_s]);
        const QJsonObject versions =
            m_work.cli({u"types"_s, u"versions"_s, u"--library"_s, u"lib.db"_s, u"--json"_s}).json();
        QCOMPARE(versions[u"versions"_s][0][u"kind"_s].toString(), u"limits"_s);
        QCOMPARE(limits(QStringList{u"--none"_s} + because()).json()[u"limits"_s].toObject(), QJsonObject());
    }
    void badInputIsRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no colon") << QStringList{u"--k"_s, u"9000"_s};
        QTest::newRow("no number") << QStringList{u"--k"_s, u"a:b"_s};
        QTest::newRow("nothing at all") << QStringList{u"--k"_s, u":"_s};
        QTest::newRow("the wrong way round") << QStringList{u"--k"_s, u"2:1"_s};
        QTest::newRow("below zero") << QStringList{u"--k"_s, u"-1:1"_s};
        QTest::newRow("infinite") << QStringList{u"--k"_s, u"1:inf"_s};
        QTest::newRow("no such rule") << QStringList{u"--k"_s, u"1:2"_s, u"--rule"_s, u"luck"_s};
        QTest::newRow("no such risk") << QStringList{u"--k"_s, u"1:2"_s, u"--risk"_s, u"0.7"_s};
        QTest::newRow("a rule for nothing") << QStringList{u"--rule"_s, u"simple"_s};
        QTest::newRow("no such type") << QStringList{u"--k"_s, u"1:2"_s, u"--type"_s, u"Z"_s};
    }
    void badInputIsRefused()
    {
        QFETCH(QStringList, arguments);
        const ProgramRun run = limits(arguments + because());
        QVERIFY2(run.exit == 2 || run.exit == 3 || run.exit == 5, qPrintable(QString::number(run.exit)));
        QVERIFY(limits({}).json()[u"rule"_s].isNull());
    }
    void aReasonIsAskedFor() { QCOMPARE(limits({u"--k"_s, u"1:2"_s}).exit, 2); }
    void theVerdictSaysWhetherThePartConforms()
    {
        QStringList files;
        for (int seed = 1; seed <= 6; ++seed) {
            files << u"s%1.csv"_s.arg(seed);
            QCOMPARE(m_work
                         .cli({u"simulate"_s, u"--object"_s, u"2,3,10"_s, u"--seed"_s, QString::number(seed),
                               u"--noise-sd"_s, u"0.01"_s, u"-o"_s, files.back()})
                         .exit,
                     0);
        }
        QCOMPARE(
            m_work.cli(QStringList{u"enroll"_s, u"--library"_s, u"own.db"_s, u"--type"_s, u"Can"_s} + files)
                .exit,
            0);
        const auto decisionWith = [&](const QString& k) {
            const ProgramRun set =
                m_work.cli(QStringList{u"types"_s, u"limits"_s, u"--library"_s, u"own.db"_s, u"--type"_s,
                                       u"Can"_s, u"--k"_s, k, u"--json"_s} +
                           because());
            if (set.exit != 0)
                return u"exit %1"_s.arg(set.exit);
            const QJsonObject result =
                m_work.cli({u"classify"_s, u"--library"_s, u"own.db"_s, u"--json"_s, files[0]})
                    .json()[u"results"_s][0]
                    .toObject();
            return result[u"verdict"_s].toString() + u' ' + result[u"conformity"_s][u"decision"_s].toString();
        };
        QCOMPARE(decisionWith(u"5:20"_s), u"type conforms"_s);
        QCOMPARE(decisionWith(u"5:6"_s), u"type does_not_conform"_s);
        const ProgramRun words = m_work.cli({u"classify"_s, u"--library"_s, u"own.db"_s, files[0]});
        QVERIFY(words.out.contains("does not conform") && words.out.contains("is above"));
    }
};

GRIPSCOPE_TEST(TypeLimitsCommandTest)
#include "type_limits_command_test.moc"
