// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

/// `gripscope-cli types`: what can be done to enrolled types, and undone.
class TypesCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    ProgramRun types(const QStringList& arguments) const
    {
        return m_work.cli(QStringList{u"types"_s} + arguments +
                          QStringList{u"--library"_s, u"lib.db"_s, u"--json"_s});
    }
    /// "A:approved:10 ..."
    QString listed(const QStringList& more = {}) const
    {
        QStringList parts;
        for (const QJsonValue type : types(QStringList{u"list"_s} + more).json()[u"types"_s].toArray())
            parts += u"%1:%2:%3"_s.arg(type[u"name"_s].toString(), type[u"status"_s].toString())
                         .arg(type[u"squeezes"_s].toInt());
        return parts.join(u' ');
    }
    static QStringList because() { return {u"--reason"_s, u"asked"_s, u"--operator"_s, u"Ada"_s}; }

private slots:
    void init()
    {
        QFile::remove(m_work.path(u"lib.db"_s));
        const auto library = Library::open(m_work.path(u"lib.db"_s));
        QVERIFY(library && (*library)->loadExampleTypes());
    }
    void everyActionIsDoneAndUndone()
    {
        const QString all = u"A:approved:10 B:approved:10 C:approved:10 D:approved:10"_s;
        QCOMPARE(listed(), all);
        QCOMPARE(types(QStringList{u"rename"_s, u"--type"_s, u"A"_s, u"--to"_s, u"Cola"_s} + because())
                     .json()[u"version"_s]
                     .toInt(),
                 2);
        QCOMPARE(types(QStringList{u"merge"_s, u"--type"_s, u"C"_s, u"--into"_s, u"D"_s} + because()).exit,
                 0);
        QCOMPARE(types(QStringList{u"retire"_s, u"--type"_s, u"B"_s} + because()).exit, 0);
        QCOMPARE(types({u"approve"_s, u"--type"_s, u"D"_s}).exit, 0);
        const auto squeezes = types({u"squeezes"_s, u"--type"_s, u"Cola"_s}).json()[u"squeezes"_s].toArray();
        QCOMPARE(squeezes.size(), 10);
        const QString keys = squeezes[0][u"key"_s].toString() + u',' + squeezes[4][u"key"_s].toString();
        QCOMPARE(types(QStringList{u"split"_s, u"--type"_s, u"Cola"_s, u"--squeezes"_s, keys, u"--to"_s,
                                   u"Light"_s} +
                       because())
                     .exit,
                 0);
        QCOMPARE(listed(), u"B:retired:10 Cola:enrolled:8 D:approved:20 Light:enrolled:2"_s);
        QCOMPARE(types(QStringList{u"reinstate"_s, u"--type"_s, u"B"_s} + because()).exit, 0);
        QCOMPARE(listed({u"--version"_s, u"1"_s}), all);
        QCOMPARE(types(QStringList{u"rollback"_s, u"--version"_s, u"1"_s} + because()).exit, 0);
        QCOMPARE(listed(), all);
        const auto versions = types({u"versions"_s}).json()[u"versions"_s].toArray();
        QCOMPARE(versions.size(), 8);
        QCOMPARE(versions[0][u"kind"_s].toString(), u"restore"_s);
        QCOMPARE(versions[0][u"operator"_s].toString(), u"Ada"_s);
        QCOMPARE(versions[6][u"change"_s].toString(), u"A was renamed Cola."_s);
    }
    void aCodeIsSetAndListed()
    {
        const QStringList code{u"code"_s, u"--type"_s, u"A"_s, u"--code"_s, u"4006381333931"_s};
        QCOMPARE(types(code + because()).json()[u"kind"_s].toString(), u"code"_s);
        QCOMPARE(types({u"list"_s}).json()[u"types"_s][0][u"code"_s].toString(), u"4006381333931"_s);
        QCOMPARE(types(code + because()).exit, 2); // it has it already
        QCOMPARE(types({u"code"_s, u"--type"_s, u"B"_s, u"--code"_s, u"4006381333931"_s, u"--reason"_s,
                        u"a mistake"_s})
                     .exit,
                 2); // A has it
        QCOMPARE(types(QStringList{u"code"_s, u"--type"_s, u"A"_s} + because()).exit, 0);
        QCOMPARE(types({u"list"_s}).json()[u"types"_s][0][u"code"_s].toString(), QString());
    }
    void whatCannotBeDoneIsToldApart()
    {
        QCOMPARE(types({u"rename"_s, u"--type"_s, u"A"_s, u"--to"_s, u"X"_s}).exit, 2); // no reason
        QCOMPARE(types(QStringList{u"rename"_s, u"--type"_s, u"X"_s, u"--to"_s, u"Y"_s} + because()).exit, 3);
        QCOMPARE(types(QStringList{u"rename"_s, u"--type"_s, u"A"_s, u"--to"_s, u"B"_s} + because()).exit, 2);
        QCOMPARE(types(QStringList{u"rollback"_s, u"--version"_s, u"9"_s} + because()).exit, 2);
        QCOMPARE(types({u"dance"_s}).exit, 2);
        QCOMPARE(m_work.cli({u"types"_s, u"list"_s, u"--library"_s, u"none.db"_s}).exit, 5);
        QVERIFY(!QFile::exists(m_work.path(u"none.db"_s)));
    }
    void guidanceAndConfusionAreTold()
    {
        const QJsonObject guide = types({u"guide"_s, u"--type"_s, u"A"_s}).json();
        QCOMPARE(guide[u"squeezes"_s].toInt(), 10);
        QCOMPARE(guide[u"more_for_gate"_s].toInt(), 0);
        QVERIFY(guide[u"gate"_s].toDouble() > guide[u"gate_limit"_s].toDouble());
        const QJsonObject loose =
            types({u"guide"_s, u"--type"_s, u"A"_s, u"--false-reject"_s, u"0.05"_s}).json();
        QVERIFY(loose[u"gate"_s].toDouble() < guide[u"gate"_s].toDouble());
        QCOMPARE(types({u"guide"_s, u"--type"_s, u"A"_s, u"--false-reject"_s, u"2"_s}).exit, 2);
        QVERIFY(guide[u"outliers"_s].toArray().isEmpty() && !guide[u"words"_s].toArray().isEmpty());
        const QJsonObject confusion = types({u"confusion"_s}).json();
        QCOMPARE(confusion[u"squeezes"_s].toInt(), 40);
        QCOMPARE(confusion[u"confusion"_s][u"A"_s][u"A"_s].toInt(), 10);
        QVERIFY(std::abs(confusion[u"wrong_type"_s][u"highest"_s].toDouble() - 0.0722) < 0.0001);
        QVERIFY(m_work.cli({u"types"_s, u"confusion"_s, u"--library"_s, u"lib.db"_s})
                    .out.contains("0 wrong of 40"));
    }
};

GRIPSCOPE_TEST(TypesCommandTest)
#include "types_command_test.moc"
