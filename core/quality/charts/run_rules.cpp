// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/quality/charts/live_chart.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int longestCount = 1 << 20; // counts stop there; no rule looks that far

int countedOn(int count, bool goesOn)
{
    return goesOn ? std::min(count + 1, longestCount) : 0;
}

RuleSet ruleBit(int rule, bool broken)
{
    return broken ? RuleSet(1U << (rule - 1)) : RuleSet(0);
}

} // namespace

QString toString(RunRules rules)
{
    switch (rules) {
    case RunRules::None:
        return u"none"_s;
    case RunRules::WesternElectric:
        return u"western-electric"_s;
    case RunRules::Nelson:
        return u"nelson"_s;
    }
    return {};
}

std::vector<int> rulesIn(RuleSet rules)
{
    std::vector<int> list;
    for (int rule = 1; rule <= 16; ++rule)
        if ((rules >> (rule - 1)) & 1U)
            list.push_back(rule);
    return list;
}

Finding ruleInWords(RunRules rules, int rule)
{
    if (rule == 1 || rules == RunRules::None)
        return Words::say("one point beyond its limits");
    // the rules that both have, as Nelson counts them
    const int nelson = rules == RunRules::Nelson ? rule : rule == 2 ? 5 : rule == 3 ? 6 : 2;
    switch (nelson) {
    case 2:
        return Words::say("%1 points in a row on one side of the centre")
            .arg(rules == RunRules::Nelson ? 9 : 8);
    case 3:
        return Words::say("6 points in a row that rise, or fall");
    case 4:
        return Words::say("14 points in a row that alternate up and down");
    case 5:
        return Words::say("2 of 3 points in a row more than 2 sigma from the centre, on one side");
    case 6:
        return Words::say("4 of 5 points in a row more than 1 sigma from the centre, on one side");
    case 7:
        return Words::say("15 points in a row within 1 sigma of the centre");
    default:
        return Words::say("8 points in a row more than 1 sigma from the centre, on either side");
    }
}

void RunRuleWatch::remember(double z)
{
    m_aboveOne = (m_aboveOne << 1) | unsigned(z > 1);
    m_belowOne = (m_belowOne << 1) | unsigned(z < -1);
    m_aboveTwo = (m_aboveTwo << 1) | unsigned(z > 2);
    m_belowTwo = (m_belowTwo << 1) | unsigned(z < -2);
    if (z > 0)
        m_side = countedOn(std::max(0, m_side), true);
    else
        m_side = -countedOn(std::max(0, -m_side), z < 0);
    m_inside = countedOn(m_inside, std::abs(z) < 1);
    m_outside = countedOn(m_outside, std::abs(z) > 1);
    const int direction = !m_any || z == m_last ? 0 : z > m_last ? 1 : -1;
    // a row of points has one step fewer: the first step makes two of them
    if (direction == 0) {
        m_trend = m_alternate = 1;
    } else {
        const bool same = direction == m_direction;
        m_trend = same ? countedOn(m_trend, true) : 2;
        m_alternate = m_direction != 0 && !same ? countedOn(m_alternate, true) : 2;
    }
    m_direction = direction;
    m_last = z;
    m_any = true;
}

bool RunRuleWatch::oneSided(unsigned high, unsigned low, int of, int enough) const
{
    const unsigned window = (1U << of) - 1;
    for (const unsigned side : {high, low})
        if ((side & 1U) && std::popcount(side & window) >= enough)
            return true;
    return false;
}

RuleSet RunRuleWatch::westernElectric() const
{
    return ruleBit(2, oneSided(m_aboveTwo, m_belowTwo, 3, 2)) |
           ruleBit(3, oneSided(m_aboveOne, m_belowOne, 5, 4)) | ruleBit(4, std::abs(m_side) >= 8);
}

RuleSet RunRuleWatch::nelson() const
{
    return ruleBit(2, std::abs(m_side) >= 9) | ruleBit(3, m_trend >= 6) | ruleBit(4, m_alternate >= 14) |
           ruleBit(5, oneSided(m_aboveTwo, m_belowTwo, 3, 2)) |
           ruleBit(6, oneSided(m_aboveOne, m_belowOne, 5, 4)) | ruleBit(7, m_inside >= 15) |
           ruleBit(8, m_outside >= 8);
}

RuleSet RunRuleWatch::add(double z)
{
    remember(z);
    const RuleSet beyond = ruleBit(1, std::abs(z) > 3);
    switch (m_rules) {
    case RunRules::None:
        break;
    case RunRules::WesternElectric:
        return beyond | westernElectric();
    case RunRules::Nelson:
        return beyond | nelson();
    }
    return beyond;
}

} // namespace gripscope
