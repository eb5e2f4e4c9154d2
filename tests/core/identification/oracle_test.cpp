// SPDX-License-Identifier: GPL-3.0-or-later
// Published records with exact answers, to the agreement contracts ask for.
#include "core/identification/identification.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

QJsonObject readOracle(const QString& file)
{
    QFile input(file);
    if (!input.open(QIODevice::ReadOnly))
        return {};
    return QJsonDocument::fromJson(input.readAll()).object();
}

std::vector<double> numbers(const QJsonValue& array)
{
    std::vector<double> values;
    for (const QJsonValue& value : array.toArray())
        values.push_back(value.toDouble());
    return values;
}

Recording recordingOf(const QJsonObject& oracle)
{
    Recording recording;
    recording.sampleTime_s = oracle[u"Ts"].toDouble();
    recording.force = numbers(oracle[u"u"]);
    recording.position = numbers(oracle[u"y"]);
    for (std::size_t i = 0; i < recording.force.size(); ++i)
        recording.time_s.push_back(static_cast<double>(i) * recording.sampleTime_s);
    return recording;
}

IdentificationOptions oracleOptions(Estimator estimator, InitialState state)
{
    IdentificationOptions options;
    options.estimators = {estimator};
    options.hold = ForceHold::Zero;
    options.initialState = state;
    options.freeOffset = false;
    return options;
}

QString disagreement(const QString& what, double got, double want, double tolerance, double scale)
{
    const double error = std::abs(got - want) / scale;
    if (error <= tolerance)
        return {};
    return u"%1: %2 against %3 (error %4, allowed %5)"_s.arg(what)
        .arg(got, 0, 'g', 17)
        .arg(want, 0, 'g', 17)
        .arg(error)
        .arg(tolerance);
}

#define VERIFY_NEAR(what, got, want, tolerance, scale)                                                       \
    do {                                                                                                     \
        const QString wrong = disagreement(what, got, want, tolerance, scale);                               \
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));                                                        \
    } while (false)

} // namespace

class OracleTest : public QObject {
    Q_OBJECT
private slots:
    void arxAgrees_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("estimator");
        QTest::addColumn<QString>("answer");
        QTest::addColumn<QString>("mapping");
        const QDir folder(QStringLiteral(GRIPSCOPE_TEST_DATA "/oracles"));
        const std::array<std::array<QString, 3>, 3> kinds{
            {{u"arx"_s, u"arx211"_s, u"mbk_cd"_s},
             {u"arx-mean-force"_s, u"arx211_avg_u"_s, u"mbk_cd"_s},
             {u"arx221"_s, u"arx221"_s, u"mbk_pole"_s}}};
        for (const QString& name : folder.entryList({u"*.json"_s})) {
            const QJsonObject oracle = readOracle(folder.filePath(name));
            for (const auto& kind : kinds) {
                if (oracle[kind[1]].isObject())
                    QTest::addRow("%s %s", qPrintable(name), qPrintable(kind[0]))
                        << folder.filePath(name) << kind[0] << kind[1] << kind[2];
            }
        }
    }
    void arxAgrees()
    {
        QFETCH(QString, file);
        QFETCH(QString, estimator);
        QFETCH(QString, answer);
        QFETCH(QString, mapping);
        const QJsonObject oracle = readOracle(file);
        const QJsonObject want = oracle[answer].toObject();
        const Estimator kind = *estimatorFromString(estimator);
        const Identification result = identify(recordingOf(oracle), oracleOptions(kind, InitialState::Free));
        const Estimate& got = result.estimates.at(0);

        const double tolerance = std::max(1e-9, 1e-14 * want[u"cond"].toDouble());
        QVERIFY(got.coefficients.has_value());
        VERIFY_NEAR(u"a1"_s, got.coefficients->a1, want[u"a1"].toDouble(), tolerance,
                    std::abs(want[u"a1"].toDouble()));
        VERIFY_NEAR(u"a2"_s, got.coefficients->a2, want[u"a2"].toDouble(), tolerance,
                    std::abs(want[u"a2"].toDouble()));
        const std::vector<double> b = numbers(want[u"b"]);
        VERIFY_NEAR(u"b1"_s, got.coefficients->b1, b[0], tolerance, std::abs(b[0]));
        if (b.size() > 1)
            VERIFY_NEAR(u"b2"_s, got.coefficients->b2.value_or(0), b[1], tolerance, std::abs(b[1]));
        const std::vector<double> parameters = numbers(want[mapping]);
        if (parameters.empty()) {
            QCOMPARE(toString(got.status), u"no_physical_mapping"_s);
            QVERIFY(!got.parameters);
        } else {
            QVERIFY(got.parameters.has_value());
            for (int i = 0; i < 3; ++i)
                VERIFY_NEAR(u"parameter %1"_s.arg(i), got.parameters->vector()(i), parameters[std::size_t(i)],
                            10 * tolerance, parameters[std::size_t(i)]);
        }
        // Contracts allow 1e-5 percent points; the outside check uses 1e-6.
        VERIFY_NEAR(u"prediction"_s, got.fit.predictionPercent.value_or(-1), want[u"pred_fit"].toDouble(),
                    1e-6, 1.0);
        VERIFY_NEAR(u"simulation"_s, got.fit.simulationPercent.value_or(-1), want[u"sim_fit_x0"].toDouble(),
                    1e-6, 1.0);
        if (oracle[u"noise_sd"].toDouble() > 0)
            VERIFY_NEAR(u"sse"_s, got.residuals.sse, want[u"sse"].toDouble(), 1e-9, want[u"sse"].toDouble());
    }

    void outputErrorAgrees_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("answer");
        const QDir folder(QStringLiteral(GRIPSCOPE_TEST_DATA "/oracles"));
        for (const QString& name : folder.entryList({u"*.json"_s})) {
            const QJsonObject oracle = readOracle(folder.filePath(name));
            for (const QString& answer : {u"oe"_s, u"oe_rest"_s}) {
                if (oracle[answer].isObject())
                    QTest::addRow("%s %s", qPrintable(name), qPrintable(answer))
                        << folder.filePath(name) << answer;
            }
        }
    }
    void outputErrorAgrees()
    {
        QFETCH(QString, file);
        QFETCH(QString, answer);
        const QJsonObject oracle = readOracle(file);
        const QJsonObject want = oracle[answer].toObject();
        const bool rest = answer == u"oe_rest"_s;
        const Identification result =
            identify(recordingOf(oracle),
                     oracleOptions(Estimator::OutputError, rest ? InitialState::Rest : InitialState::Free));
        const Estimate& got = result.estimates.at(0);
        QCOMPARE(toString(got.status), u"converged"_s);
        const std::array<QString, 3> names{u"m"_s, u"b"_s, u"k"_s};
        const std::vector<double> errors = numbers(want[u"se"]);
        const bool noisy = oracle[u"noise_sd"].toDouble() > 0;
        const bool exact =
            want[u"sse"].toDouble() < 1e-20; // the record is the model's own: the answer is the truth
        for (int i = 0; i < 3; ++i) {
            const QString& name = names[std::size_t(i)];
            const double parameter = want[name].toDouble();
            VERIFY_NEAR(name, got.parameters->vector()(i), parameter, exact ? 1e-11 : 1e-8, parameter);
            if (noisy)
                VERIFY_NEAR(u"error of "_s + name, (*got.standardErrors())(i), errors[std::size_t(i)], 1e-6,
                            errors[std::size_t(i)]);
        }
        VERIFY_NEAR(u"fit"_s, got.fit.simulationPercent.value_or(-1), want[u"fit"].toDouble(), 1e-7, 1.0);
        QVERIFY(got.fit.predictionPercent == got.fit.simulationPercent);
        if (noisy && !rest) {
            VERIFY_NEAR(u"x0"_s, got.nuisance.x0.value_or(0), want[u"x0"].toDouble(), 1e-6, errors[3]);
            VERIFY_NEAR(u"v0"_s, got.nuisance.v0.value_or(0), want[u"v0"].toDouble(), 1e-6, errors[4]);
        }
    }
};

GRIPSCOPE_TEST(OracleTest)
#include "oracle_test.moc"
