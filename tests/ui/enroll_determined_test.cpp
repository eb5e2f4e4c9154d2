// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/models_by_space.h"
#include "tests/ui/enroll_steps.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/pages/enroll/enroll_review_panel.h"
#include "ui/pages/enroll/enroll_squeeze_panel.h"

#include <QLabel>
#include <QPushButton>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;
using gripscope::test::pageAtSqueezes;
using gripscope::test::squeezeAndAccept;
using gripscope::test::WindowFixture;

/// Types that have more than m, b and k, or less, by click and key from the name to the verdict.
class EnrollDeterminedTest : public QObject {
    Q_OBJECT

    static void toReview(WindowFixture& f)
    {
        f.click(f.find<QPushButton>("reviewButton"));
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->enrollment().step(), EnrollSession::Step::Review,
                                  test::longEnough_ms);
    }
    /// What the review has a line for.
    static QStringList shownRows(WindowFixture& f)
    {
        QStringList shown;
        for (const QLabel* label : f.find<QWidget>("reviewFacts")->findChildren<QLabel*>(u"quantityName"_s))
            if (label->isVisible())
                shown << label->text();
        return shown;
    }
    static DeterminedQuantities ofStiffness(double k)
    {
        return {{{TypeQuantity::Stiffness}},
                LogVector::Constant(1, std::log(k)),
                LogMatrix::Constant(1, 1, 1e-6)};
    }

private slots:
    void aPartThatYieldsIsATypeWithHowItYields()
    {
        WindowFixture f(false, u"virtual:?object=A&zener=0.3,0.03&seed=5&speed=0"_s);
        f.bench->arm();
        pageAtSqueezes(f, u"foam"_s);
        for (int i = 0; i < 4; ++i)
            squeezeAndAccept(f);
        QVERIFY(f.find<QLabel>("squeezeNumbers")->text().contains(u"τ"_s));
        toReview(f);
        const QStringList expected{u"moving mass m"_s, u"damping b"_s, u"stiffness k"_s,
                                   u"yielding share k1/k"_s, u"yields within τ"_s};
        QTRY_COMPARE_WITH_TIMEOUT(shownRows(f), expected, test::longEnough_ms);
    }

    void aSqueezeWithoutAMassShowsWhatThereIs()
    {
        EnrollSqueeze squeeze;
        squeeze.recording.forceUnit = u"N"_s;
        squeeze.recording.positionUnit = u"m"_s;
        squeeze.determined = ofStiffness(9990);
        QVERIFY2(numbersOf(squeeze).startsWith(u"k  9.99 "_s), qPrintable(numbersOf(squeeze)));
        QVERIFY2(numbersOf(squeeze).endsWith(u"m  –"_s), qPrintable(numbersOf(squeeze)));
        EnrollSqueezeModel model;
        QVERIFY(model.refresh({squeeze}));
        const auto cell = [&model](EnrollSqueezeModel::Column column) {
            return model.index(0, static_cast<int>(column)).data().toString();
        };
        QCOMPARE(cell(EnrollSqueezeModel::Column::Mass), u"–"_s);
        QVERIFY2(cell(EnrollSqueezeModel::Column::Stiffness).startsWith(u"9.99"_s),
                 qPrintable(cell(EnrollSqueezeModel::Column::Stiffness)));
    }

    void aTypeWithoutAMassIsReviewedByWhatThereIs()
    {
        std::vector<TypeSqueeze> squeezes;
        for (const double e : {0.98, 1.0, 1.02}) {
            squeezes.push_back({u"soft"_s, {}});
            squeezes.back().determined = ofStiffness(1000 * e);
            squeezes.push_back({u"hard"_s, {}});
            squeezes.back().determined = ofStiffness(1500 * e);
        }
        const ModelsBySpace types(squeezes);
        const TypeReview review = reviewType(squeezes, types, u"soft"_s, {});
        QCOMPARE(review.squeezes, 3);
        QCOMPARE(review.quantities.size(), std::size_t(1));
        QVERIFY(review.quantities[0].quantity == TypeQuantity::Stiffness);
        QVERIFY(std::abs(review.quantities[0].mean - 1000) < 1e-6);
        QVERIFY(std::abs(*review.quantities[0].deviation - 20) < 1e-6);
        QCOMPARE(review.nearest, u"hard"_s);
        QVERIFY(review.gateSd && *review.nearestSd > *review.gateSd);
    }
};

GRIPSCOPE_TEST(EnrollDeterminedTest)
#include "enroll_determined_test.moc"
