// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/drift.h"
#include "tests/core/recognition/noisy_types.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <numeric>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const Eigen::Matrix3d changeBetween = covarianceOf(0.03, 0.04, 0.03, 0.2);
const Eigen::Matrix3d changeNoise = covarianceOf(0.01, 0.01, 0.005, 0);

/// Squeezes of types in turn; behind `before` of them those of `moved` (all: -1) are changed.
struct Course {
    Course(std::uint64_t seed, int count, int enrolled = 20)
        : source(seed, changeBetween), models(fitTypeModels(source.enrolment(count, enrolled, changeNoise))),
          types(count)
    {
    }
    std::vector<TypeSqueeze> squeezes(int all, int before, const Eigen::Vector3d& shift, int moved = -1)
    {
        std::vector<TypeSqueeze> result;
        for (int i = 0; i < all; ++i) {
            const int type = i % types;
            const bool isMoved = i >= before && (moved < 0 || moved == type);
            Eigen::Vector3d at = NoisyTypes::mean(type);
            if (isMoved)
                at += shift;
            result.push_back(
                NoisyTypes::squeeze(QString(QChar(u'A' + type)), source.log(at, changeNoise), changeNoise));
        }
        return result;
    }
    NoisyTypes source;
    TypeModels models;
    int types;
};

} // namespace

/// Since when squeezes lie elsewhere.
class ChangePointTest : public QObject {
    Q_OBJECT
private slots:
    void theIntervalHasTheTrueMoment()
    {
        constexpr int runs = 150, all = 60;
        int covered = 0, shiftCovered = 0;
        for (int run = 0; run < runs; ++run) {
            Course course(std::uint64_t(run + 1), 3);
            const int before = 5 + (run * 7) % 45;
            const Eigen::Vector3d shift(0.04, 0.04, 0.04); // about one standard deviation
            const auto found =
                findChange(course.models, course.squeezes(all, before, shift), ShiftKind::Factor);
            QVERIFY(found);
            covered += found->earliest <= before && before <= found->latest;
            shiftCovered += std::abs(found->shift(2) - shift(2)) < 1.96 * std::sqrt(found->covariance(2, 2));
            QVERIFY(found->earliest <= found->before && found->before <= found->latest);
            QVERIFY(std::abs(std::accumulate(found->posterior.begin(), found->posterior.end(), 0.0) - 1) <
                    1e-9);
        }
        // At least 95 % (the set is whole numbers, and its range has what lies between): 142 +- 2.7.
        QVERIFY2(covered >= 135, qPrintable(QString::number(covered)));
        // Given the most probable moment alone the shift's interval is a little narrow.
        QVERIFY2(shiftCovered >= 127, qPrintable(QString::number(shiftCovered)));
    }
    void aClearChangeIsDatedToTheSqueeze()
    {
        Course course(500, 3);
        const auto found =
            findChange(course.models, course.squeezes(60, 31, {0.3, 0.3, 0.3}), ShiftKind::Factor);
        QVERIFY(found);
        QCOMPARE(found->before, 31);
        QVERIFY(found->earliest == 31 && found->latest == 31 && found->probability > 0.95);
        QVERIFY(std::abs(found->shift(0) - 0.3) < 4 * std::sqrt(found->covariance(0, 0)));
    }
    void whatWasSoFromTheFirstOneIsOlder()
    {
        Course course(501, 3);
        const auto found =
            findChange(course.models, course.squeezes(40, 0, {0.3, 0.3, 0.3}), ShiftKind::Factor);
        QVERIFY(found && found->before == 0 && found->earliest == 0);
    }
    void oneTypeIsDatedAmongTheOthers()
    {
        Course course(502, 3);
        const auto found = findChange(course.models, course.squeezes(90, 45, {0.2, 0.2, -0.2}, 1),
                                      ShiftKind::Factor, {u"B"_s});
        QVERIFY(found);
        QCOMPARE(found->before, 46); // the first of B from there on, counted among all
    }
    void additionsAreDatedToo()
    {
        Course course(503, 2);
        std::vector<TypeSqueeze> squeezes = course.squeezes(60, 60, Eigen::Vector3d::Zero());
        double added = 0;
        for (const TypeModel& type : course.models.types)
            added += 0.15 * std::exp(type.meanLog(2));
        for (std::size_t i = 20; i < squeezes.size(); ++i)
            squeezes[i].parameters.k += added;
        const auto found = findChange(course.models, squeezes, ShiftKind::Addition);
        QVERIFY(found && std::abs(found->before - 20) <= 2);
    }
    void tooFewSayNothing()
    {
        Course course(504, 2);
        QVERIFY(!findChange(course.models, course.squeezes(4, 2, {1, 1, 1}), ShiftKind::Factor));
        QVERIFY(!findChange({}, course.squeezes(40, 2, {1, 1, 1}), ShiftKind::Factor));
        QVERIFY(!findChange(course.models, course.squeezes(40, 2, {1, 1, 1}), ShiftKind::Factor, {u"Z"_s}));
    }
};

GRIPSCOPE_TEST(ChangePointTest)
#include "change_point_test.moc"
