// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

/// Types that m, b and k do not tell apart, from the gripper to the verdict.
class DeterminedTypesTest : public QObject {
    Q_OBJECT

    QString squeezed(const QString& part, int seed, const QString& file)
    {
        const QString device = u"virtual:?object=%1&speed=0&seed=%2"_s.arg(part).arg(seed);
        const ProgramRun run =
            m_work.cli({u"record"_s, u"--device"_s, device, u"--seconds"_s, u"1"_s, u"--excitation"_s,
                        u"four-level"_s, u"--peak"_s, u"10"_s, u"--bias"_s, u"20"_s, u"--bit"_s, u"0.005"_s,
                        u"--arm"_s, u"-o"_s, m_work.path(file)});
        if (run.exit != 0)
            qWarning("%s", run.err.constData());
        return m_work.path(file);
    }
    bool enrol(const QString& library, const QString& name, const QString& part, int first)
    {
        QStringList arguments{u"enroll"_s, u"--library"_s, m_work.path(library), u"--type"_s, name};
        for (int seed = first; seed < first + 6; ++seed)
            arguments << squeezed(part, seed, u"%1-%2.csv"_s.arg(name).arg(seed));
        const ProgramRun run = m_work.cli(arguments);
        if (run.exit != 0)
            qWarning("%s%s", run.out.constData(), run.err.constData());
        return run.exit == 0;
    }
    QJsonObject verdict(const QString& library, const QString& part, int seed)
    {
        const QString file = squeezed(part, seed, u"again-%1.csv"_s.arg(seed));
        const ProgramRun run =
            m_work.cli({u"classify"_s, u"--library"_s, m_work.path(library), u"--json"_s, file});
        return run.json()[u"results"].toArray().at(0).toObject();
    }
    static QString told(const QJsonObject& verdict)
    {
        return QString::fromUtf8(QJsonDocument(verdict).toJson(QJsonDocument::Compact));
    }

    Workplace m_work;

private slots:
    void foamsOfOneMotionAreToldApartByHowTheyYield()
    {
        const QString quick = u"A&zener=0.3,0.02"_s;
        const QString slow = u"A&zener=0.3,0.08"_s;
        QVERIFY(enrol(u"foam.db"_s, u"quick"_s, quick, 1));
        QVERIFY(enrol(u"foam.db"_s, u"slow"_s, slow, 11));
        for (int seed = 101; seed < 104; ++seed) {
            const QJsonObject one = verdict(u"foam.db"_s, quick, seed);
            QVERIFY2(one[u"type"].toString() == u"quick"_s, qPrintable(told(one)));
            const QJsonObject other = verdict(u"foam.db"_s, slow, seed + 10);
            QVERIFY2(other[u"type"].toString() == u"slow"_s, qPrintable(told(other)));
        }
        const QJsonObject can = verdict(u"foam.db"_s, u"B"_s, 121); // does not yield, and is another can
        QVERIFY2(can[u"verdict"].toString() == u"unknown"_s, qPrintable(told(can)));
        // It has m, b and k in common with them, and is judged by these.
        QVERIFY2(
            told(can).contains(u"Judged by mass, damping and stiffness: the squeeze determines no more."_s),
            qPrintable(told(can)));
    }
    /// The example library, and the parts that a virtual gripper holds for it.
    void simulatedPlasticsFoamsAndFruitAreToldApart()
    {
        const QStringList load{
            u"library"_s, u"examples"_s, u"--simulated"_s, u"--library"_s, m_work.path(u"fruit.db"_s),
            u"--json"_s};
        const ProgramRun loaded = m_work.cli(load);
        QVERIFY2(loaded.exit == 0, loaded.err.constData());
        QCOMPARE(loaded.json()[u"types"].toArray().size(), 6);
        QCOMPARE(m_work.cli(load).json()[u"types"].toArray().size(), 6); // once
        const std::pair<QString, QString> parts[] = {
            {u"bottle"_s, u"Plastic bottle (simulated)"_s}, {u"cup"_s, u"Plastic cup (simulated)"_s},
            {u"firm-foam"_s, u"Firm foam (simulated)"_s},   {u"soft-foam"_s, u"Soft foam (simulated)"_s},
            {u"apple"_s, u"Apple (simulated)"_s},           {u"tomato"_s, u"Tomato (simulated)"_s}};
        int seed = 301;
        for (const auto& [object, type] : parts) {
            const QString device = u"virtual:?object=%1&speed=0&seed=%2"_s.arg(object).arg(seed++);
            const ProgramRun squeezed =
                m_work.cli({u"record"_s, u"--device"_s, device, u"--seconds"_s, u"1"_s, u"--excitation"_s,
                            u"four-level"_s, u"--peak"_s, u"5"_s, u"--bias"_s, u"10"_s, u"--bit"_s, u"0.01"_s,
                            u"--arm"_s, u"-o"_s, u"part.csv"_s});
            QVERIFY2(squeezed.exit == 0, squeezed.err.constData());
            const QJsonObject one =
                m_work.cli({u"classify"_s, u"--library"_s, u"fruit.db"_s, u"--json"_s, u"part.csv"_s})
                    .json()[u"results"]
                    .toArray()
                    .at(0)
                    .toObject();
            QVERIFY2(one[u"type"].toString() == type, qPrintable(told(one)));
        }
    }
    /// At 50 samples a second the can has come to rest before the next one: no mass, and k tells them apart.
    /// Of one number strangers have more often what a type has: some verdicts stay open, none is wrong.
    void aSlowGripperRecognisesByStiffness()
    {
        const QString soft = u"0.04,43,10000&rate=50"_s;
        const QString hard = u"0.04,43,14000&rate=50"_s;
        QVERIFY(enrol(u"slow.db"_s, u"soft"_s, soft, 1));
        QVERIFY(enrol(u"slow.db"_s, u"hard"_s, hard, 11));
        int named = 0;
        for (int seed = 101; seed < 104; ++seed) {
            const QJsonObject one = verdict(u"slow.db"_s, soft, seed);
            QVERIFY2(one[u"nearest"].toString() == u"soft"_s && one[u"verdict"].toString() != u"unknown"_s,
                     qPrintable(told(one)));
            QVERIFY2(one[u"validity"].toString() == u"valid"_s, qPrintable(told(one)));
            QVERIFY2(
                told(one).contains(u"Judged by stiffness alone: the squeezes enrolled determine no more."_s),
                qPrintable(told(one)));
            const QJsonObject other = verdict(u"slow.db"_s, hard, seed + 10);
            QVERIFY2(other[u"nearest"].toString() == u"hard"_s &&
                         other[u"verdict"].toString() != u"unknown"_s,
                     qPrintable(told(other)));
            named += (one[u"type"].isString() ? 1 : 0) + (other[u"type"].isString() ? 1 : 0);
        }
        QVERIFY2(named >= 3, qPrintable(QString::number(named)));
        const QJsonObject none = verdict(u"slow.db"_s, u"0.04,43,30000&rate=50"_s, 121);
        QVERIFY2(none[u"verdict"].toString() == u"unknown"_s, qPrintable(told(none)));
    }
};

GRIPSCOPE_TEST(DeterminedTypesTest)
#include "determined_types_test.moc"
