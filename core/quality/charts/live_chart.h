// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/quality/charts/chart_constants.h"
#include "core/quality/charts/subgroups.h"

#include <cstdint>
#include <map>
#include <optional>
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

enum class ChartKind {
    Individuals,   ///< "i-mr": values and their moving ranges of two
    MeanRange,     ///< "xbar-r"
    MeanDeviation, ///< "xbar-s"
    Ewma,          ///< "ewma"
    Cusum,         ///< "cusum"
};
[[nodiscard]] QString toString(ChartKind kind);

/// A chart whose limits are settled. Lengths in the unit of the values.
struct ChartSetting {
    ChartKind kind = ChartKind::Individuals;
    double centre = 0;                    ///< mu, or the target
    double sigma = 1;                     ///< of one value, within subgroups
    RunRules rules = RunRules::None;      ///< Shewhart charts of values and means only
    double weight = 0.2, width = 3;       ///< EWMA: lambda in (0, 1], L
    double reference = 0.5, decision = 5; ///< CUSUM: k and h, in standard deviations of what is summed
    double size = 1;                      ///< values in a subgroup, on average

    /// Usage, with what is out of its range.
    [[nodiscard]] std::optional<Error> validate() const;
};

struct ChartPoint {
    double value = 0; ///< what is drawn; of a CUSUM the mean that is summed
    double lower = 0, upper = 0;
    double upperSum = 0, lowerSum = 0; ///< CUSUM
    RuleSet rules = 0;                 ///< that are broken here
};

/// What one value or one subgroup adds.
struct ChartStep {
    ChartPoint location;
    std::optional<ChartPoint> spread; ///< moving range, range or deviation; not of one value alone
};

/// A control chart with limits that are settled, one value or subgroup at a time; a whole table goes through
/// the same (chart_study.h). With n values in the subgroup, x their mean and s = sigma/sqrt(n):
///     Shewhart    centre +- 3 s; rules by (x - centre)/s
///     moving range, range   d2 sigma +- 3 d3 sigma, not below 0
///     deviation   c4 sigma +- 3 sigma sqrt(1 - c4^2), not below 0
///     EWMA        e_t = w x_t + (1 - w) e_(t-1), e_0 = centre, centre +- L sd(e_t), exact in t:
///                 var(e_t) = w^2 s_t^2 + (1 - w)^2 var(e_(t-1))
///     CUSUM       C+_t = max(0, C+_(t-1) + z - k), C-_t = max(0, C-_(t-1) - z - k), z = (x - centre)/s,
///                 signal above h; told times sigma/sqrt(`size`), between limits of -h and h times that
/// Assumes independent values. Sources: Montgomery, Introduction to Statistical Quality Control, ch. 6 and 9;
/// Roberts 1959 (EWMA), Page 1954 (CUSUM).
class LiveChart {
public:
    [[nodiscard]] static Expected<LiveChart> of(const ChartSetting& setting);

    /// BadInput for what is not finite; the chart then stays as it was. Of charts of ranges and deviations
    /// one value is a subgroup of one.
    Expected<ChartStep> add(double value) { return add(std::span<const double>(&value, 1)); }
    /// Besides: no value; several on a chart of individuals.
    Expected<ChartStep> add(std::span<const double> subgroup);

    [[nodiscard]] const ChartSetting& setting() const { return m_setting; }

private:
    explicit LiveChart(const ChartSetting& setting)
        : m_setting(setting), m_watch(setting.rules), m_average(setting.centre)
    {
    }
    [[nodiscard]] ChartPoint location(const SubgroupSummary& summary);
    [[nodiscard]] ChartPoint shewhart(double mean, double deviation);
    [[nodiscard]] ChartPoint movingAverage(double mean, double deviation);
    [[nodiscard]] ChartPoint sums(double mean, double deviation);
    [[nodiscard]] std::optional<ChartPoint> spread(const SubgroupSummary& summary);
    [[nodiscard]] const ChartConstants& constants(std::size_t size);

    ChartSetting m_setting;
    RunRuleWatch m_watch;
    double m_average, m_averageVariance = 0; ///< EWMA
    double m_upperSum = 0, m_lowerSum = 0;   ///< CUSUM, in standard deviations
    std::optional<double> m_last;            ///< the value before
    std::map<std::size_t, ChartConstants> m_constants;
};

} // namespace gripscope
