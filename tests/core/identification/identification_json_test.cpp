// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "core/identification/result/identification_json.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::Synthetic;

namespace {

QJsonObject documentOf(const Recording& recording)
{
    return toJson(identify(recording), recording, u"squeeze.csv"_s);
}

QJsonObject estimateOf(const QJsonObject& document, const QString& name)
{
    for (const QJsonValue& e : document[u"estimates"].toArray()) {
        if (e[u"estimator"].toString() == name)
            return e.toObject();
    }
    return {};
}

QStringList sorted(QStringList keys)
{
    keys.sort();
    return keys;
}

} // namespace

class IdentificationJsonTest : public QObject {
    Q_OBJECT
private slots:
    void theDocumentHasTheContractsKeys()
    {
        Recording recording = Synthetic().make();
        recording.forceUnit = u"N"_s;
        recording.positionUnit = u"mm"_s;
        const QJsonObject document = documentOf(recording);
        for (const QString& key :
             {u"file"_s, u"recording"_s, u"estimates"_s, u"recommended"_s, u"validity"_s, u"budget"_s,
              u"derived"_s, u"comparison"_s, u"validation"_s, u"preparation"_s})
            QVERIFY2(document.contains(key), qPrintable(key));
        QCOMPARE(document[u"file"].toString(), u"squeeze.csv"_s);
        const QJsonObject about = document[u"recording"].toObject();
        QCOMPARE(about.keys(), sorted({u"samples"_s, u"sample_time_s"_s, u"gaps"_s, u"hold"_s, u"units"_s}));
        QCOMPARE(about[u"samples"].toInt(), 400);
        QCOMPARE(about[u"hold"].toString(), u"zoh"_s);
        QCOMPARE(about[u"units"][u"m"].toString(), u"N s^2/mm"_s);
        QCOMPARE(about[u"units"][u"position"].toString(), u"mm"_s);
        const QJsonObject oe = estimateOf(document, u"oe"_s);
        QCOMPARE(oe.keys(), sorted({u"estimator"_s, u"status"_s, u"parameters"_s, u"standard_errors"_s,
                                    u"covariance"_s, u"nuisance"_s, u"coefficients"_s, u"fit"_s,
                                    u"residuals"_s, u"noise"_s, u"iterations"_s, u"part"_s}));
        QCOMPARE(oe[u"nuisance"].toObject().keys(), sorted({u"x0"_s, u"v0"_s, u"offset"_s}));
        QCOMPARE(oe[u"coefficients"].toObject().keys(),
                 sorted({u"a1"_s, u"a2"_s, u"b1"_s, u"b2"_s, u"constant"_s}));
        QCOMPARE(oe[u"fit"].toObject().keys(), sorted({u"simulation_percent"_s, u"prediction_percent"_s}));
        QCOMPARE(oe[u"residuals"].toObject().keys(),
                 sorted({u"sse"_s, u"degrees_of_freedom"_s, u"whiteness_p"_s, u"input_independence_p"_s}));
        for (const QJsonValue& check : document[u"validity"][u"checks"].toArray())
            QCOMPARE(check.toObject().keys(),
                     sorted({u"id"_s, u"ok"_s, u"value"_s, u"limit"_s, u"message"_s}));
    }
    void aCubicSpringIsTheFourthParameter()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 95;
        const Recording recording = synthetic.make();
        IdentificationOptions options;
        options.estimators = {Estimator::Duffing};
        const Identification found = identify(recording, options);
        const QJsonObject duffing = estimateOf(toJson(found, recording, u"x"_s), u"duffing"_s);
        const Estimate& e = *found.find(Estimator::Duffing);
        QCOMPARE(duffing[u"parameters"].toObject().keys(), sorted({u"m"_s, u"b"_s, u"k"_s, u"k3"_s}));
        QCOMPARE(duffing[u"parameters"][u"k3"].toDouble(), e.motion->values[MotionParameter::Cubic]);
        QCOMPARE(duffing[u"covariance"].toArray().size(), 4);
        QCOMPARE(duffing[u"covariance"][0][3].toDouble(), e.motion->covariance(0, 3));
        QCOMPARE(duffing[u"standard_errors"][u"k3"].toDouble(), std::sqrt(e.motion->covariance(3, 3)));
    }
    void numbersKeepEveryDigit()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 90;
        const Recording recording = synthetic.make();
        const Identification found = identify(recording);
        const QByteArray text =
            QJsonDocument(toJson(found, recording, u"x"_s)).toJson(QJsonDocument::Compact);
        const QJsonObject oe = estimateOf(QJsonDocument::fromJson(text).object(), u"oe"_s);
        const Estimate& e = *found.find(Estimator::OutputError);
        QVERIFY(oe[u"parameters"][u"m"].toDouble() == e.parameters->m);
        QVERIFY(oe[u"standard_errors"][u"k"].toDouble() == (*e.standardErrors())(2));
        QVERIFY(oe[u"covariance"][0][2].toDouble() == (*e.covariance)(0, 2));
        QVERIFY(oe[u"fit"][u"simulation_percent"].toDouble() == *e.fit.simulationPercent);
    }
    void whatDoesNotExistIsNull()
    {
        Synthetic synthetic;
        synthetic.kind = ExcitationKind::Step;
        const QJsonObject document = documentOf(synthetic.make());
        const QJsonObject oe = estimateOf(document, u"oe"_s);
        QCOMPARE(oe[u"status"].toString(), u"not_identifiable"_s);
        QVERIFY(oe[u"parameters"].isNull());
        QVERIFY(oe[u"standard_errors"].isNull());
        QVERIFY(oe[u"covariance"].isNull());
        QVERIFY(oe[u"fit"][u"simulation_percent"].isNull());
        QVERIFY(oe[u"residuals"][u"sse"].isNull());
        QVERIFY(oe[u"nuisance"][u"x0"].isNull());
        QCOMPARE(document[u"validity"][u"verdict"].toString(), u"invalid"_s);
        const QJsonObject arx = estimateOf(documentOf(Synthetic().make()), u"arx"_s);
        QVERIFY(arx[u"nuisance"][u"x0"].isNull());
        QVERIFY(arx[u"coefficients"][u"b2"].isNull());
        QVERIFY(arx[u"coefficients"][u"a1"].isDouble());
    }
    void anEmptyRecordingIsADocumentToo()
    {
        const QJsonObject document = documentOf(Recording());
        QCOMPARE(document[u"recording"][u"samples"].toInt(-1), 0);
        QCOMPARE(document[u"validity"][u"verdict"].toString(), u"invalid"_s);
        const QByteArray text = QJsonDocument(document).toJson();
        QVERIFY(!text.contains("nan") && !text.contains("inf"));
    }
};

GRIPSCOPE_TEST(IdentificationJsonTest)
#include "identification_json_test.moc"
