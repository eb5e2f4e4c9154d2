// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/paper_appendix.h"
#include "core/recognition/verdict/verdict.h"
#include "core/session/enroll/enrollment_advice.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;
using Decision = EnrollSqueeze::Decision;

namespace {

/// A squeeze in N and mm: m and k are the SI values over 1,000.
EnrollSqueeze decided(const MassDampingStiffness& p, Decision decision, const QString& part = {})
{
    EnrollSqueeze squeeze;
    squeeze.recording.forceUnit = u"N"_s;
    squeeze.recording.positionUnit = u"mm"_s;
    squeeze.decision = decision;
    squeeze.part = part;
    Estimate estimate;
    estimate.estimator = Estimator::OutputError;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = MassDampingStiffness{p.m / 1000, p.b / 1000, p.k / 1000};
    squeeze.identification.recommended = estimate.estimator;
    squeeze.identification.estimates = {estimate};
    return squeeze;
}

/// The paper's first can once more, as an enrolment that is under way.
std::vector<EnrollSqueeze> enrollmentOfCanA()
{
    std::vector<EnrollSqueeze> squeezes;
    for (const TypeSqueeze& squeeze : paperSqueezesInSi())
        if (squeeze.type == u"A"_s)
            squeezes.push_back(decided(squeeze.parameters, Decision::Accepted));
    return squeezes;
}

} // namespace

class EnrollmentAdviceTest : public QObject {
    Q_OBJECT
private slots:
    void acceptedAndPendingSqueezesAreAskedAboutInSi()
    {
        const MassDampingStiffness p{0.04, 43, 9990};
        const std::vector<EnrollSqueeze> squeezes{decided(p, Decision::Rejected),
                                                  decided(p, Decision::Accepted, u"7"_s),
                                                  decided(p, Decision::Pending)};
        const AdviceRequest request = adviceRequest(u"A"_s, squeezes, {});
        QCOMPARE(request.accepted.size(), std::size_t(1));
        QCOMPARE(request.rows, std::vector<int>{1});
        QCOMPARE(request.accepted[0].parameters.k, 9990.0);
        QCOMPARE(request.accepted[0].part, u"7"_s);
        QVERIFY(request.pending && request.siUnits);
        QCOMPARE(request.pendingRow, 2);
        QVERIFY(request == adviceRequest(u"A"_s, squeezes, {}));
        QVERIFY(!(request == adviceRequest(u"B"_s, squeezes, {})));
    }
    void aPendingSqueezeOfAnotherPartIsAnOutlierAtOnce()
    {
        std::vector<EnrollSqueeze> squeezes = enrollmentOfCanA();
        squeezes.push_back(decided({0.0396, 43, 3500}, Decision::Pending));
        const EnrollmentAdvice advice = advise(adviceRequest(u"A"_s, squeezes, {}), paperSqueezesInSi());
        QCOMPARE(advice.progress.squeezes, 10); // the pending one is not enrolled yet
        QCOMPARE(advice.outliers.size(), std::size_t(1));
        QCOMPARE(advice.outliers.begin()->first, 10);
        QVERIFY(advice.outliers.begin()->second.reason.describe().contains(u"below the others"_s));
    }
    void theReviewChecksTheWholeLibrary()
    {
        const EnrollmentReview review =
            reviewEnrollment(adviceRequest(u"A"_s, enrollmentOfCanA(), {}), paperSqueezesInSi());
        QCOMPARE(review.confusion.squeezes, 40);
        QCOMPARE(review.confusion.wrongType.failures, 0);
        QVERIFY(review.advice.outliers.empty() && !review.partDeviation);
    }
    void partsAreToldFromGrips()
    {
        std::vector<EnrollSqueeze> squeezes = enrollmentOfCanA();
        for (std::size_t i = 0; i < squeezes.size(); ++i)
            squeezes[i].part = QString::number(i / 2);
        const EnrollmentReview review =
            reviewEnrollment(adviceRequest(u"A"_s, squeezes, {}), paperSqueezesInSi());
        QVERIFY(review.partDeviation && review.regripDeviation);
    }
    void adviceIsAtTheRatesThatAreSet()
    {
        VerdictOptions strict;
        strict.falseReject = 0.05;
        strict.strangerAccept = 0.001;
        const AdviceRequest request = adviceRequest(u"A"_s, enrollmentOfCanA(), strict);
        const AdviceRequest usual = adviceRequest(u"A"_s, enrollmentOfCanA(), {});
        QVERIFY(!(request == usual));
        const EnrollmentProgress progress = advise(request, paperSqueezesInSi()).progress;
        QCOMPARE(progress.falseReject, 0.05);
        QVERIFY(*progress.gate < *advise(usual, paperSqueezesInSi()).progress.gate);
        const QString words = described(inWords(progress)).join(u' ');
        QVERIFY2(words.contains(u"as 5 % of its own are"_s) && words.contains(u"at most 0.1 %"_s),
                 qPrintable(words));
        // The gate of the advice is that of the verdicts.
        const Verdict verdict =
            judge(fitTypeModels(paperSqueezesInSi()), request.accepted.front().parameters, strict);
        QVERIFY(std::abs(*progress.gate - std::sqrt(*verdict.gate)) < 1e-6);
    }
    void nothingToAdviseOnIsNoTrouble()
    {
        const EnrollmentAdvice advice = advise(adviceRequest(u"A"_s, {}, {}), {});
        QCOMPARE(advice.progress.squeezes, 0);
        QVERIFY(advice.outliers.empty());
    }
};

GRIPSCOPE_TEST(EnrollmentAdviceTest)
#include "enrollment_advice_test.moc"
