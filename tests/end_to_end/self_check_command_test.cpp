// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFileInfo>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

QJsonObject checked(const ProgramRun& run, const QString& id)
{
    for (const QJsonValue& line : run.json()[u"lines"].toArray())
        if (line[u"id"].toString() == id)
            return line.toObject();
    return {};
}

} // namespace

class SelfCheckCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

private slots:
    void nothingIsBrokenWhereNothingIsYet()
    {
        const ProgramRun run = m_work.cli({u"self-check"_s, u"--json"_s});
        QVERIFY2(run.exit == 0 || run.exit == 4, run.out.constData()); // 4: a gripper hangs on this computer
        QCOMPARE(run.json()[u"lines"].toArray().size(), 9);
        QCOMPARE(checked(run, u"library"_s)[u"outcome"].toString(), u"ok"_s);
        QVERIFY(!QFileInfo::exists(m_work.path(u"gripscope/library.db"_s)));
    }

    void aLibraryIsToldInWords()
    {
        QCOMPARE(m_work.cli({u"library"_s, u"examples"_s}).exit, 0);
        const ProgramRun run = m_work.cli({u"self-check"_s});
        QVERIFY2(run.out.contains("rows are as they were written"), run.out.constData());
        QVERIFY2(run.out.contains("ok      Library"), run.out.constData());
        QVERIFY(run.out.contains("Qt "));
        const ProgramRun quick = m_work.cli({u"self-check"_s, u"--quick"_s, u"--json"_s});
        QCOMPARE(checked(quick, u"integrity"_s)[u"found"].toString(), u"not looked at"_s);
    }

    void aKeyThatOthersMayReadIsBroken()
    {
        QCOMPARE(m_work.cli({u"library"_s, u"examples"_s}).exit, 0);
        const QString key = m_work.path(u"gripscope/station.key"_s);
        QVERIFY(QFile::setPermissions(key, QFileDevice::ReadOwner | QFileDevice::WriteOwner |
                                               QFileDevice::ReadOther));
        const ProgramRun run = m_work.cli({u"self-check"_s, u"--json"_s});
        QCOMPARE(checked(run, u"keys"_s)[u"outcome"].toString(), u"broken"_s);
        QVERIFY(checked(run, u"keys"_s)[u"advice"].toString().contains(u"chmod 600"_s));
        QVERIFY(run.exit == 5 || run.exit == 4);
        QCOMPARE(run.json()[u"broken"].toBool(), true);
        QVERIFY(QFile::setPermissions(key, QFileDevice::ReadOwner | QFileDevice::WriteOwner));
    }

    void aLibraryThatCannotBeReadExitsWith5()
    {
        m_work.write(u"bad.db"_s, QByteArray(5000, 'x'));
        const ProgramRun run =
            m_work.cli({u"self-check"_s, u"--library"_s, m_work.path(u"bad.db"_s), u"--json"_s});
        QCOMPARE(checked(run, u"library"_s)[u"outcome"].toString(), u"broken"_s);
        QVERIFY(run.exit == 5 || run.exit == 4);
    }
};

GRIPSCOPE_TEST(SelfCheckCommandTest)
#include "self_check_command_test.moc"
