// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/simulated_parts.h"
#include "core/session/enroll/simulated_examples.h"
#include "core/session/squeeze/comparable_units.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class SimulatedExamplesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { m_examples = simulatedExamples(); }

    /// What is enrolled was found by identify(); it is where the parts were drawn about, 4 % each way.
    void theyAreWhatWasSimulated()
    {
        const std::vector<SimulatedPart>& parts = simulatedParts();
        QCOMPARE(m_examples.size(), parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const SimulatedPart& part = parts[i];
            QCOMPARE(m_examples[i].name, part.name);
            QVERIFY(part.name.contains(u"simulated"_s));
            LogVector mean = LogVector::Zero(5);
            for (const NewGrasp& grasp : m_examples[i].squeezes) {
                QVERIFY2(grasp.determined, qPrintable(part.name));
                QCOMPARE(grasp.determined->space.dimensions(), 5); // m, b, k, k1/k, tau
                mean += grasp.determined->log / double(m_examples[i].squeezes.size());
                QCOMPARE(grasp.source, u"simulated"_s);
            }
            const double truth[] = {part.centre.m, part.centre.b, part.centre.k, part.relaxingShare,
                                    part.relaxationTime_s};
            // k1/k varies as k1 and k do: sqrt(2) of 4 %. Four deviations of a mean of six, and the noise.
            constexpr double deviation = 0.04 * 1.4142 / 2.4495;
            for (Eigen::Index j = 0; j < 5; ++j)
                QVERIFY2(std::abs(mean(j) - std::log(truth[j])) < 4 * deviation + 0.05,
                         qPrintable(u"%1, %2: %3"_s.arg(part.name).arg(j).arg(mean(j) - std::log(truth[j]))));
        }
    }
    void theLibraryTakesThemOnce()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->loadExampleTypes());
        valueOf(library->loadExampleTypes(m_examples));
        valueOf(library->loadExampleTypes(m_examples));
        const std::vector<TypeRecord> types = valueOf(library->types());
        QCOMPARE(types.size(), std::size_t(4 + 6));
        for (const TypeRecord& type : types)
            QVERIFY(type.approved);
        QCOMPARE(valueOf(library->version()), 2);
        const ComparableTypes comparable(types, valueOf(library->enrolledSqueezes()));
        QCOMPARE(comparable.modelsFor(u"N"_s, u"m"_s)->types->whole()->types.size(), std::size_t(10));
    }
    void theyAreTheSameEveryTime()
    {
        const std::vector<ExampleType> again = simulatedExamples();
        for (std::size_t i = 0; i < again.size(); ++i)
            for (std::size_t j = 0; j < again[i].squeezes.size(); ++j)
                QVERIFY(again[i].squeezes[j].determined->log == m_examples[i].squeezes[j].determined->log);
    }

private:
    std::vector<ExampleType> m_examples;
};

GRIPSCOPE_TEST(SimulatedExamplesTest)
#include "simulated_examples_test.moc"
