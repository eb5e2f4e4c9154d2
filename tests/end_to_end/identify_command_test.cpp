// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QLocale>

#include <algorithm>
#include <cmath>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const QStringList reading{u"--force-column"_s, u"u"_s, u"--position-column"_s, u"y"_s};

QByteArray exactly(const QJsonValue& value)
{
    return QByteArray::number(value.toDouble(), 'g', QLocale::FloatingPointShortest);
}

QByteArray csvOf(const QJsonObject& oracle)
{
    QByteArray text = "u,y\n";
    const QJsonArray u = oracle[u"u"].toArray(), y = oracle[u"y"].toArray();
    for (qsizetype i = 0; i < u.size(); ++i)
        text += exactly(u[i]) + ',' + exactly(y[i]) + '\n';
    return text;
}

bool near(const QJsonValue& got, double want, double tolerance)
{
    return got.isDouble() && std::abs(got.toDouble() - want) <= tolerance * std::abs(want);
}

} // namespace

class IdentifyCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    QJsonObject oracle(const QString& name)
    {
        QFile file(QStringLiteral(GRIPSCOPE_TEST_DATA "/oracles/") + name);
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    }
    QJsonObject estimate(const QStringList& arguments)
    {
        return m_work.cli(arguments).json()[u"estimates"][0].toObject();
    }

private slots:
    void anEstimateIsHeldAgainstAnotherSqueeze()
    {
        const auto squeeze = [this](const QString& file, const QString& object, const QString& seed) {
            return m_work
                .cli({u"simulate"_s, u"--object"_s, object, u"--noise-sd"_s, u"0.3"_s, u"--seed"_s, seed,
                      u"-o"_s, file})
                .exit;
        };
        QCOMPARE(squeeze(u"one.csv"_s, u"0.04,0.137,0.1"_s, u"1"_s), 0);
        QCOMPARE(squeeze(u"same.csv"_s, u"0.04,0.137,0.1"_s, u"2"_s), 0);
        QCOMPARE(squeeze(u"other.csv"_s, u"0.04,0.137,0.15"_s, u"3"_s), 0);
        const auto against = [this](const QStringList& option) {
            return m_work.cli(QStringList{u"identify"_s, u"--json"_s, u"one.csv"_s} + option)
                .json()[u"validation"]
                .toObject();
        };
        const QJsonObject alone = against({});
        QCOMPARE(alone[u"on"].toString(), u"second_window"_s);
        QCOMPARE(alone[u"validated_on"][u"first"].toInt(), 240);
        const QJsonObject same = against({u"--validate"_s, u"same.csv"_s});
        QCOMPARE(same[u"file"].toString(), u"same.csv"_s);
        QVERIFY(same[u"as_expected"].toBool());
        QVERIFY(!against({u"--validate"_s, u"other.csv"_s})[u"as_expected"].toBool(true));
        QCOMPARE(m_work.cli({u"identify"_s, u"one.csv"_s, u"--validate"_s, u"none.csv"_s}).exit, 3);
    }
    void theDocumentHasTheShapeThatIsPromised()
    {
        QCOMPARE(m_work
                     .cli({u"simulate"_s, u"--object"_s, u"1,1.2,1"_s, u"--bit"_s, u"1"_s, u"--noise-sd"_s,
                           u"0.02"_s, u"-o"_s, u"s.csv"_s})
                     .exit,
                 0);
        const ProgramRun run = m_work.cli({u"identify"_s, u"--json"_s, u"s.csv"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY(run.err.isEmpty());
        const QJsonObject document = run.json();
        QCOMPARE(document[u"file"].toString(), u"s.csv"_s);
        const QJsonObject recording = document[u"recording"].toObject();
        QCOMPARE(recording[u"samples"].toInt(), 400);
        QCOMPARE(recording[u"sample_time_s"].toDouble(), 0.05);
        QCOMPARE(recording[u"gaps"].toInt(-1), 0);
        QCOMPARE(recording[u"hold"].toString(), u"zoh"_s);
        QCOMPARE(recording[u"units"][u"m"].toString(), u"1"_s);
        QCOMPARE(document[u"recommended"].toString(), u"oe"_s);
        QCOMPARE(document[u"validity"][u"verdict"].toString(), u"valid"_s);
        QVERIFY(!document[u"validity"][u"checks"].toArray().isEmpty());

        const QJsonArray estimates = document[u"estimates"].toArray();
        QCOMPARE(estimates.size(), 2); // arx,oe
        QCOMPARE(estimates[0][u"estimator"].toString(), u"arx"_s);
        const QJsonObject oe = estimates[1].toObject();
        QCOMPARE(oe[u"estimator"].toString(), u"oe"_s);
        QCOMPARE(oe[u"status"].toString(), u"converged"_s);
        QCOMPARE(oe[u"covariance"].toArray().size(), 3);
        for (const auto key : {"nuisance", "coefficients", "residuals", "iterations"})
            QVERIFY2(oe.contains(QLatin1String(key)), key);
        QCOMPARE(oe[u"fit"][u"simulation_percent"], oe[u"fit"][u"prediction_percent"]);
        const QJsonObject errors = oe[u"standard_errors"].toObject();
        const double truth[] = {1, 1.2, 1};
        int i = 0;
        for (const auto key : {"m", "b", "k"}) {
            const double error = errors[QLatin1String(key)].toDouble();
            QVERIFY(error > 0);
            // five standard errors: one run in two million would fail, and the seed is fixed
            QVERIFY(std::abs(oe[u"parameters"][QLatin1String(key)].toDouble() - truth[i++]) < 5 * error);
        }
    }
    void asATableEachFileAndEstimatorHasARow()
    {
        QVERIFY(m_work
                    .cli({u"simulate"_s, u"--object"_s, u"1,1.2,1"_s, u"--noise-sd"_s, u"0.02"_s, u"-o"_s,
                          u"good.csv"_s})
                    .exit == 0);
        m_work.write(u"bad.csv"_s, "time_s,force,position\n0,1,2\n0.05,x,2\n");
        const ProgramRun run = m_work.cli({u"identify"_s, u"--csv"_s, u"good.csv"_s, u"bad.csv"_s});
        QCOMPARE(run.exit, 3);
        const QList<QByteArray> lines = run.out.trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(4)); // header, arx, oe, the bad one
        const QList<QByteArray> names = lines[0].split(',');
        const auto cell = [&](qsizetype row, const QByteArray& name) {
            return lines[row].split(',').value(names.indexOf(name));
        };
        QCOMPARE(cell(1, "estimator"), QByteArray("arx"));
        QCOMPARE(cell(2, "estimator"), QByteArray("oe"));
        QCOMPARE(cell(2, "recommended"), QByteArray("yes"));
        QCOMPARE(cell(2, "m_unit"), QByteArray("1"));
        QCOMPARE(lines[2].count(','), names.size() - 1);
        const QJsonObject document = m_work.cli({u"identify"_s, u"--json"_s, u"good.csv"_s}).json();
        const QJsonObject oe = document[u"estimates"][1].toObject();
        QCOMPARE(cell(2, "k").toDouble(), oe[u"parameters"][u"k"].toDouble());
        QVERIFY(cell(2, "k_95").toDouble() > oe[u"standard_errors"][u"k"].toDouble());
        QCOMPARE(cell(2, "validity"), document[u"validity"][u"verdict"].toString().toUtf8());
        QVERIFY(lines[3].startsWith("bad.csv,,") && lines[3].contains("bad.csv:3:2"));
        QCOMPARE(m_work.cli({u"identify"_s, u"--csv"_s, u"--json"_s, u"good.csv"_s}).exit, 2);
    }
    void aTableOfAnotherProgramIsRead()
    {
        QVERIFY(m_work
                    .cli({u"simulate"_s, u"--object"_s, u"1,1.2,1"_s, u"--noise-sd"_s, u"0.02"_s, u"-o"_s,
                          u"own.csv"_s})
                    .exit == 0);
        QFile own(m_work.path(u"own.csv"_s));
        QVERIFY(own.open(QIODevice::ReadOnly));
        QByteArray plain, rows;
        for (const QByteArray& line : own.readAll().split('\n'))
            if (!line.isEmpty() && line[0] >= '0' && line[0] <= '9') {
                plain += line + '\n';
                rows += QByteArray(line).replace(',', ';').replace('.', ',') + '\n';
            }
        const QStringList ask{u"identify"_s, u"--json"_s, u"--estimator"_s,   u"oe"_s,
                              u"--hold"_s,   u"zoh"_s,    u"--sample-time"_s, u"0.05"_s};
        m_work.write(u"plain.csv"_s, "time_s,force,position\n" + plain);
        const QJsonObject same = estimate(ask + QStringList{u"plain.csv"_s});
        QVERIFY(same[u"parameters"].isObject());

        m_work.write(u"other.txt"_s, "Versuch;7;x\nZeit;Kraft;Weg\ns;N;mm\n" + rows);
        const QStringList byName{u"--skip-lines"_s,      u"1"_s,    u"--skip-below"_s,   u"1"_s,
                                 u"--time-column"_s,     u"Zeit"_s, u"--force-column"_s, u"Kraft"_s,
                                 u"--position-column"_s, u"Weg"_s,  u"other.txt"_s};
        QCOMPARE(estimate(ask + byName)[u"parameters"], same[u"parameters"]);

        m_work.write(u"bare.txt"_s, rows);
        const QStringList byNumber{
            u"--no-header"_s,       u"--delimiter"_s, u"semicolon"_s,      u"--decimal-comma"_s,
            u"--time-column"_s,     u"1"_s,           u"--force-column"_s, u"2"_s,
            u"--position-column"_s, u"3"_s,           u"bare.txt"_s};
        QCOMPARE(estimate(ask + byNumber)[u"parameters"], same[u"parameters"]);
        QCOMPARE(m_work.cli({u"identify"_s, u"bare.txt"_s, u"--delimiter"_s, u"blank"_s}).exit, 2);
    }
    void everyFileHasADocumentAndABadOneDoesNotStopTheOthers()
    {
        QVERIFY(m_work.cli({u"simulate"_s, u"--object"_s, u"1,1.2,1"_s, u"-o"_s, u"good.csv"_s}).exit == 0);
        m_work.write(u"bad.csv"_s, "time_s,force,position\n0,1,2\n0.05,x,2\n");
        const ProgramRun run = m_work.cli(
            {u"identify"_s, u"--json"_s, u"good.csv"_s, u"bad.csv"_s, u"missing.csv"_s, u"good.csv"_s});
        QCOMPARE(run.exit, 3);
        const QList<QJsonObject> documents = run.jsonLines();
        QCOMPARE(documents.size(), 4);
        QCOMPARE(documents[0][u"recommended"].toString(), u"oe"_s);
        QCOMPARE(documents[1][u"file"].toString(), u"bad.csv"_s);
        QCOMPARE(documents[1][u"error"][u"code"].toString(), u"bad_input"_s);
        QVERIFY(documents[1][u"error"][u"message"].toString().contains(u"bad.csv:3:2"_s));
        QVERIFY(run.err.contains("bad.csv:3:2"));
        QCOMPARE(documents[2][u"error"][u"code"].toString(), u"file_unreadable"_s);
        QVERIFY(run.err.contains("missing.csv"));
        QCOMPARE(documents[3], documents[0]);
    }
    void badInputIsAMessageOrAStatusNeverACrash_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("exit");
        QTest::addColumn<QByteArray>("place");
        QByteArray constant = "u,y\n", nans = "u,y\n";
        for (int i = 0; i < 100; ++i) {
            constant += "1,1\n";
            nans += "1,nan\n";
        }
        QTest::newRow("bad row") << QByteArray("u,y\n1,2\n1,x\n") << 3 << QByteArray(".csv:3:2");
        QTest::newRow("truncated") << QByteArray("u,y\n1,2\n1") << 3 << QByteArray(".csv:3");
        QTest::newRow("NaN") << nans << 3 << QByteArray(".csv:2:2");
        QTest::newRow("infinite") << QByteArray("u,y\n1,2\ninf,2\n") << 3 << QByteArray(".csv:3:1");
        QTest::newRow("empty") << QByteArray() << 3 << QByteArray(".csv:1");
        QTest::newRow("header only") << QByteArray("u,y\n") << 3 << QByteArray(".csv");
        QTest::newRow("other columns") << QByteArray("a,b\n1,2\n") << 3 << QByteArray(".csv:1");
        QTest::newRow("not text") << QByteArray("\x00\xff\xfe\x80u,y\n1,2\n", 14) << 3 << QByteArray(".csv");
        QTest::newRow("constant force") << constant << 6 << QByteArray();
        QTest::newRow("three samples") << QByteArray("u,y\n1,0\n1,1\n0,1\n") << 6 << QByteArray();
    }
    void badInputIsAMessageOrAStatusNeverACrash()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, exit);
        QFETCH(QByteArray, place);
        m_work.write(u"input.csv"_s, text);
        for (const bool json : {false, true}) {
            QStringList arguments = QStringList{u"identify"_s, u"input.csv"_s} + reading +
                                    QStringList{u"--sample-time"_s, u"0.05"_s, u"--estimator"_s, u"all"_s};
            if (json)
                arguments << u"--json"_s;
            const ProgramRun run = m_work.cli(arguments);
            if (place.startsWith(".csv") && run.exit == 6)
                QVERIFY(QByteArray(QTest::currentDataTag()) == "header only"); // no rows may be a status, too
            else
                QCOMPARE(run.exit, exit);
            if (run.exit == 3)
                QVERIFY2(run.err.contains("input" + place), run.err.constData());
            if (json) {
                QVERIFY(!run.json().isEmpty());
                QVERIFY(!run.out.contains(":nan") && !run.out.contains(":inf"));
            }
            if (json && run.exit == 6)
                for (const QJsonValue& estimate : run.json()[u"estimates"].toArray())
                    QVERIFY(estimate[u"parameters"].isNull() &&
                            estimate[u"status"].toString() != u"converged"_s);
        }
    }
    void publishedAnswersComeOutOfTheProgramToo()
    {
        const QString name = u"zoh_prbs_C_fit90.json"_s;
        const QJsonObject o = oracle(name);
        QVERIFY(!o.isEmpty());
        m_work.write(u"oracle.csv"_s, csvOf(o));
        const QStringList ask = QStringList{u"identify"_s, u"oracle.csv"_s} + reading +
                                QStringList{u"--sample-time"_s, QString::fromLatin1(exactly(o[u"Ts"])),
                                            u"--hold"_s,        u"zoh"_s,
                                            u"--offset"_s,      u"fixed"_s,
                                            u"--json"_s};
        const QJsonObject arx = estimate(ask + QStringList{u"--estimator"_s, u"arx"_s});
        const QJsonObject want = o[u"arx211"].toObject();
        QVERIFY(near(arx[u"coefficients"][u"a1"], want[u"a1"].toDouble(), 1e-9));
        QVERIFY(near(arx[u"coefficients"][u"b1"], want[u"b"][0].toDouble(), 1e-9));
        QVERIFY(near(arx[u"parameters"][u"m"], want[u"mbk_cd"][0].toDouble(), 1e-8));
        for (const QString& state : {u"free"_s, u"rest"_s}) {
            const QJsonObject oe =
                estimate(ask + QStringList{u"--estimator"_s, u"oe"_s, u"--initial-state"_s, state});
            const QJsonObject answer = o[state == u"free"_s ? u"oe"_s : u"oe_rest"_s].toObject();
            for (int i = 0; i < 3; ++i) {
                const QString key = QStringList{u"m"_s, u"b"_s, u"k"_s}[i];
                QVERIFY(near(oe[u"parameters"][key], answer[key].toDouble(), 1e-6));
                QVERIFY(near(oe[u"standard_errors"][key], answer[u"se"][i].toDouble(), 1e-4));
            }
            QVERIFY(std::abs(oe[u"fit"][u"simulation_percent"].toDouble() - answer[u"fit"].toDouble()) <
                    1e-5);
        }
    }
    void unitsOfTheChannelsGiveThoseOfTheParameters()
    {
        m_work.write(u"oracle.csv"_s, csvOf(oracle(u"zoh_prbs_A_fit99.json"_s)));
        const QJsonObject document = m_work
                                         .cli(QStringList{u"identify"_s, u"oracle.csv"_s} + reading +
                                              QStringList{u"--sample-time"_s, u"0.05"_s, u"--force-unit"_s,
                                                          u"N"_s, u"--position-unit"_s, u"mm"_s, u"--json"_s})
                                         .json();
        const QJsonObject units = document[u"recording"][u"units"].toObject();
        QCOMPARE(units[u"force"].toString(), u"N"_s);
        QCOMPARE(units[u"m"].toString(), u"N s^2/mm"_s);
        QCOMPARE(units[u"b"].toString(), u"N s/mm"_s);
        QCOMPARE(units[u"k"].toString(), u"N/mm"_s);
        QCOMPARE(document[u"recording"][u"hold"].toString(), u"foh"_s); // where nothing says otherwise
    }
    void measuredDataIsFollowed()
    {
        const QString file =
            QDir(QStringLiteral(GRIPSCOPE_SHARED_DATA)).filePath(u"silverbox/arrow_small.csv"_s);
        if (!QFile::exists(file))
            QSKIP("the Silverbox records are not here");
        const ProgramRun run = m_work.cli(QStringList{u"identify"_s, file} + reading +
                                          QStringList{u"--sample-time"_s, u"0.0016384"_s, u"--hold"_s,
                                                      u"foh"_s, u"--estimator"_s, u"oe"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY(run.json()[u"estimates"][0][u"fit"][u"simulation_percent"].toDouble() >= 97.4);
    }
    void aPersonReadsUnitsErrorsAndWhatAnArxFitDoesNotSay()
    {
        m_work.write(u"oracle.csv"_s, csvOf(oracle(u"zoh_prbs_A_fit99.json"_s)));
        const ProgramRun run = m_work.cli(QStringList{u"identify"_s, u"oracle.csv"_s} + reading +
                                          QStringList{u"--sample-time"_s, u"0.05"_s, u"--force-unit"_s,
                                                      u"N"_s, u"--position-unit"_s, u"mm"_s});
        QCOMPARE(run.exit, 0);
        for (const QByteArray word :
             {"N s^2/mm", "±", "simulation", "prediction", "says nothing about m, b and k", "(95 %)"})
            QVERIFY2(run.out.contains(word), word.constData());
    }
};

GRIPSCOPE_TEST(IdentifyCommandTest)
#include "identify_command_test.moc"
