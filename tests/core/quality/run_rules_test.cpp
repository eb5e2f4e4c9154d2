// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/live_chart.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;
using Points = std::vector<double>;

class RunRulesTest : public QObject {
    Q_OBJECT
private:
    static bool holds(const Points& z, std::size_t at, int count, int enough, double beyond)
    {
        for (const double side : {1.0, -1.0}) {
            int found = 0;
            for (int i = 0; i < count && int(at) - i >= 0; ++i)
                found += side * z[at - std::size_t(i)] > beyond;
            if (found >= enough && side * z[at] > beyond)
                return true;
        }
        return false;
    }
    template <typename Step>
    static bool row(std::size_t at, int count, Step step)
    {
        if (int(at) + 1 < count)
            return false;
        for (std::size_t i = at + 1 - std::size_t(count); i <= at; ++i)
            if (!step(i, i - (at + 1 - std::size_t(count))))
                return false;
        return true;
    }
    /// Nelson's rules as they are worded, over all points from the start.
    static std::vector<int> nelsonByTheWords(const Points& z, std::size_t at)
    {
        std::vector<int> rules;
        const auto rises = [&z](std::size_t i) { return z[i] > z[i - 1]; };
        const auto falls = [&z](std::size_t i) { return z[i] < z[i - 1]; };
        if (std::abs(z[at]) > 3)
            rules.push_back(1);
        if (holds(z, at, 9, 9, 0))
            rules.push_back(2);
        if (row(at, 6, [&](auto i, auto place) { return place == 0 || rises(i); }) ||
            row(at, 6, [&](auto i, auto place) { return place == 0 || falls(i); }))
            rules.push_back(3);
        const auto alternates = [&](auto i, auto place) {
            return place < 2 ? place == 0 || rises(i) || falls(i)
                             : (rises(i) && falls(i - 1)) || (falls(i) && rises(i - 1));
        };
        if (row(at, 14, alternates))
            rules.push_back(4);
        if (holds(z, at, 3, 2, 2))
            rules.push_back(5);
        if (holds(z, at, 5, 4, 1))
            rules.push_back(6);
        if (row(at, 15, [&](auto i, auto) { return std::abs(z[i]) < 1; }))
            rules.push_back(7);
        if (row(at, 8, [&](auto i, auto) { return std::abs(z[i]) > 1; }))
            rules.push_back(8);
        return rules;
    }
    /// The rules that the last point breaks, and none of those before it breaks `rule`.
    static bool firstAtTheEnd(RunRules system, const Points& points, int rule)
    {
        RunRuleWatch watch(system);
        bool last = false, earlier = false;
        for (const double z : points) {
            earlier = earlier || last;
            last = (watch.add(z) >> (rule - 1)) & 1U;
        }
        return last && !earlier;
    }

private slots:
    void eachRuleIsToldAtThePointThatCompletesIt()
    {
        const RunRules western = RunRules::WesternElectric, nelson = RunRules::Nelson;
        QVERIFY(firstAtTheEnd(RunRules::None, {0, 1, 3.01}, 1));
        QVERIFY(firstAtTheEnd(western, {0, -3.01}, 1));
        QVERIFY(firstAtTheEnd(western, {2.1, 0, 2.1}, 2));
        QVERIFY(!firstAtTheEnd(western, {2.1, 0, -2.1}, 2));
        QVERIFY(!firstAtTheEnd(western, {2.1, 0, 0, 2.1}, 2));
        QVERIFY(firstAtTheEnd(western, {-1.1, -1.1, 0, -1.1, -1.1}, 3));
        QVERIFY(firstAtTheEnd(western, {-.1, .1, .2, .1, .1, .1, .1, .1, .1}, 4));
        QVERIFY(firstAtTheEnd(nelson, {.1, .2, .1, .2, .1, .2, .1, .2, .1}, 2));
        QVERIFY(firstAtTheEnd(nelson, {0, .1, .2, .3, .4, .5}, 3));
        QVERIFY(!firstAtTheEnd(nelson, {0, .1, .2, .2, .4, .5}, 3));
        QVERIFY(firstAtTheEnd(nelson, {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, 4));
        QVERIFY(firstAtTheEnd(nelson, {-2.1, -2.1}, 5));
        QVERIFY(firstAtTheEnd(nelson, {1.1, 1.1, 1.1, 1.1}, 6));
        QVERIFY(firstAtTheEnd(nelson, Points(15, 0.9), 7));
        QVERIFY(firstAtTheEnd(nelson, {1.1, -1.1, 1.2, -1.2, 1.1, -1.1, 1.1, -1.1}, 8));
        QVERIFY(!firstAtTheEnd(western, {3}, 1)); // the limit itself is within
    }
    void agreesWithTheWordsOnSeriesThatAreDrawn()
    {
        std::uint32_t state = 1;
        for (int series = 0; series < 60; ++series) {
            Points z;
            RunRuleWatch watch(RunRules::Nelson);
            for (int i = 0; i < 300; ++i) {
                state = state * 1664525U + 1013904223U;
                // tenths, so that equal points and points on a border come; wide, narrow and on one side
                const double raw = double(int((state >> 16) % 71U) - 35) / 10;
                z.push_back(series % 3 == 0 ? raw : series % 3 == 1 ? raw / 3 : raw / 2 + 0.6);
                QCOMPARE(rulesIn(watch.add(z.back())), nelsonByTheWords(z, z.size() - 1));
            }
        }
    }
    void everyRuleHasWords()
    {
        for (int rule = 1; rule <= 8; ++rule)
            QVERIFY(!ruleInWords(RunRules::Nelson, rule).english().isEmpty());
        QVERIFY(ruleInWords(RunRules::WesternElectric, 4).english().startsWith(QStringLiteral("8 points")));
        QVERIFY(ruleInWords(RunRules::Nelson, 2).english().startsWith(QStringLiteral("9 points")));
        QVERIFY(ruleInWords(RunRules::WesternElectric, 2).english().startsWith(QStringLiteral("2 of 3")));
        QVERIFY(ruleInWords(RunRules::WesternElectric, 3).english().startsWith(QStringLiteral("4 of 5")));
    }
};

GRIPSCOPE_TEST(RunRulesTest)
#include "run_rules_test.moc"
