// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <cmath>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class CalibrateCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    void writePoints() const
    {
        QByteArray text = "# a load cell, up and down\nload,reading,by\n";
        for (int i = 0; i <= 20; ++i) {
            const double load = 1e5 * (i <= 10 ? i : 20 - i);
            const double reading = 0.001 + 7e-7 * load - 3e-15 * load * load + (i % 2 == 0 ? 1e-6 : -1e-6);
            text += QByteArray::number(load, 'g', 17) + ',' + QByteArray::number(reading, 'g', 17) + ",Ada\n";
        }
        m_work.write(u"points.csv"_s, text);
    }

private slots:
    void theCurveAndItsInverseComeAsADocument()
    {
        writePoints();
        const ProgramRun run = m_work.cli({u"calibrate"_s, u"points.csv"_s, u"--degree"_s, u"2"_s,
                                           u"--readings"_s, u"0.35025,9"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        const QJsonObject direct = document[u"reading_from_load"].toObject();
        QCOMPARE(direct[u"coefficients"].toArray().size(), 3);
        QVERIFY(std::abs(direct[u"coefficients"][1].toDouble() / 7e-7 - 1) < 1e-4);
        QCOMPARE(direct[u"standard_deviations"].toArray().size(), 3);
        QVERIFY(direct[u"residual_deviation"].toDouble() > 0 &&
                direct[u"residual_deviation"].toDouble() < 2e-6);
        const QJsonArray values = document[u"load_from_reading"][u"values"].toArray();
        QCOMPARE(values.size(), 2);
        // 0.001 + 7e-7 x - 3e-15 x^2 = 0.35025 at x = 5e5.
        QVERIFY(std::abs(values[0][u"load"].toDouble() / 5e5 - 1) < 1e-4);
        QVERIFY(values[0][u"standard_uncertainty"].toDouble() > 0);
        QVERIFY(values[1][u"load"].isNull()); // outside
        QVERIFY(document[u"figures"][u"reversibility_percent"].isDouble());
    }
    void textTellsTheSame()
    {
        writePoints();
        const ProgramRun run = m_work.cli({u"calibrate"_s, u"points.csv"_s});
        QCOMPARE(run.exit, 0);
        for (const char* word : {"c[2]", "linearity", "repeatability", "residual deviation"})
            QVERIFY2(run.out.contains(word), word);
    }
    void badPointsAreNamed()
    {
        m_work.write(u"few.csv"_s, "load,reading\n0,0\n1,1\n");
        const ProgramRun few = m_work.cli({u"calibrate"_s, u"few.csv"_s, u"--json"_s});
        QVERIFY(few.exit != 0);
        QCOMPARE(few.json()[u"error"][u"code"].toString(), u"bad_input"_s);
        QVERIFY(few.err.contains("few.csv"));
        m_work.write(u"words.csv"_s, "load,reading\n0,zero\n");
        QVERIFY(m_work.cli({u"calibrate"_s, u"words.csv"_s}).err.contains("words.csv:2:2"));
        QVERIFY(m_work.cli({u"calibrate"_s, u"nowhere.csv"_s}).exit != 0);
        QVERIFY(
            m_work.cli({u"calibrate"_s, u"few.csv"_s, u"--readings"_s, u"a"_s}).err.contains("--readings"));
    }
};

GRIPSCOPE_TEST(CalibrateCommandTest)
#include "calibrate_command_test.moc"
