// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

#include <cstdint>
#include <vector>

namespace gripscope {

/// Which patterns besides a point beyond its limits are signals.
enum class RunRules { None, WesternElectric, Nelson };
[[nodiscard]] QString toString(RunRules rules); ///< "none", "western-electric", "nelson"

/// Rules that a point breaks, rule r as bit r - 1.
using RuleSet = std::uint16_t;
[[nodiscard]] std::vector<int> rulesIn(RuleSet rules); ///< from 1, ascending
/// "2 of 3 points in a row more than 2 sigma from the centre, on one side"
[[nodiscard]] Finding ruleInWords(RunRules rules, int rule);

/// Watches standardized points z = (value - centre) / (standard deviation of the value), one after another.
///
/// None: 1 |z| > 3.
/// Western Electric (Statistical Quality Control Handbook, 1956): 1 |z| > 3; 2 two of three in a row beyond 2
/// on one side; 3 four of five beyond 1 on one side; 4 eight in a row on one side.
/// Nelson (The Shewhart control chart: tests for special causes, Journal of Quality Technology 1984): 1 |z| >
/// 3; 2 nine in a row on one side; 3 six in a row that rise, or fall; 4 fourteen in a row that alternate; 5
/// two of three beyond 2 on one side; 6 four of five beyond 1 on one side; 7 fifteen in a row within 1; 8
/// eight in a row beyond 1, on either side.
///
/// A pattern is told at the point that completes it, which is one of those that count, and at each further
/// one that keeps it up. "Beyond" leaves out the border; a point on the centre is on neither side; equal
/// points neither rise nor fall.
class RunRuleWatch {
public:
    explicit RunRuleWatch(RunRules rules) : m_rules(rules) {}

    /// The rules that this point breaks. `z` finite.
    RuleSet add(double z);

private:
    void remember(double z);
    [[nodiscard]] bool oneSided(unsigned high, unsigned low, int of, int enough) const;
    [[nodiscard]] RuleSet westernElectric() const;
    [[nodiscard]] RuleSet nelson() const;

    RunRules m_rules;
    unsigned m_aboveOne = 0, m_belowOne = 0, m_aboveTwo = 0, m_belowTwo = 0; ///< the newest as bit 0
    int m_side = 0;      ///< how many in a row on one side, negative below
    int m_trend = 0;     ///< how many in a row rise, negative where they fall
    int m_alternate = 0; ///< how many in a row alternate
    int m_inside = 0, m_outside = 0;
    int m_direction = 0; ///< of the last step
    double m_last = 0;
    bool m_any = false;
};

} // namespace gripscope
