// SPDX-License-Identifier: GPL-3.0-or-later
// A motor-driven axis without a spring, ruled by friction (EMPS: Janot, Gautier, Brunot 2019; M 95.1 kg by
// inverse dynamics).
#include "core/identification/estimators/run_estimator.h"
#include "core/identification/identification.h"
#include "core/signal/preparation/preparation.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"

#include <QFileInfo>
#include <QTest>

using namespace gripscope;
using P = MotionParameter;

class EmpsTest : public QObject {
    Q_OBJECT
    Recording m_recording;

private slots:
    void initTestCase()
    {
        const QString file = QStringLiteral(GRIPSCOPE_SHARED_DATA "/emps/arrow.csv");
        if (!QFileInfo::exists(file))
            QSKIP("the records of the axis are not there");
        const auto recording = readRecordingCsv(file);
        QVERIFY(recording.has_value());
        m_recording = *recording;
    }
    void theCarriageIsFoundWhereNoSpringIs()
    {
        const PreparedRecord record = prepare(m_recording, {});
        EstimatorTask task;
        task.hold = m_recording.hold.value(); // the record tells it
        const Estimate carriage = runEstimator(Estimator::Carriage, record, task);
        QVERIFY2(carriage.status == EstimateStatus::Converged, qPrintable(carriage.message.english()));
        QVERIFY(!carriage.parameters); // it has no k
        QVERIFY2(carriage.fit.simulationPercent.value_or(0) >= 97,
                 qPrintable(QString::number(*carriage.fit.simulationPercent)));
        const double mass = carriage.motion->values[P::Mass];
        const double halfWidth = 1.96 * std::sqrt(carriage.motion->covariance(0, 0));
        QVERIFY2(std::abs(mass - 95.1) < halfWidth && halfWidth < 10,
                 qPrintable(QStringLiteral("%1 +- %2").arg(mass).arg(halfWidth)));
        QVERIFY(std::abs(carriage.motion->values[P::Friction] - 20.4) < 3);
        const Estimate spring = runEstimator(Estimator::OutputError, record, task);
        QVERIFY(!spring.parameters);
        QVERIFY(!spring.message.isEmpty());
    }
    /// What a person is told: an interval for each, and no stiffness.
    void thePersonIsToldHowSure()
    {
        IdentificationOptions options;
        options.estimators = {Estimator::OutputError, Estimator::Carriage};
        const Identification found = identify(m_recording, options);
        QVERIFY(found.recommended == Estimator::Carriage);
        QVERIFY(found.best() == nullptr && !found.budget.parameters);
        QVERIFY(found.budget.further.size() == 4 && found.budget.further[0].parameter == P::Mass);
        const CoverageInterval& mass = found.budget.further[0].interval;
        QVERIFY2(mass.lower < 95.1 && 95.1 < mass.upper && mass.upper - mass.lower <= 20,
                 qPrintable(QStringLiteral("%1 to %2").arg(mass.lower).arg(mass.upper)));
        for (const ValidityCheck& check : found.validity.checks)
            QVERIFY2(check.ok || !check.decisive, qPrintable(check.message.english()));
    }
};

GRIPSCOPE_TEST(EmpsTest)
#include "emps_test.moc"
