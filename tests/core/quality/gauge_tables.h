// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random_stream.h"
#include "core/quality/gauge/gauge_study.h"

#include <array>
#include <cmath>
#include <vector>

namespace gripscope::test {

/// A row: which part, operator and station (-1: there is none), and its value.
struct GaugeRow {
    int part = 0, operators = 0, station = -1;
    double value = 0;
};

inline StudyLabels numberedLabels(const std::vector<int>& numbers)
{
    StudyLabels labels;
    for (const int number : numbers) {
        const QString name = QString::number(number);
        if (!labels.names.contains(name))
            labels.names << name;
        labels.index.push_back(int(labels.names.indexOf(name)));
    }
    return labels;
}

inline GaugeFactors factorsOf(const std::vector<GaugeRow>& rows)
{
    std::array<std::vector<int>, 3> numbers;
    for (const GaugeRow& row : rows) {
        numbers[0].push_back(row.part);
        numbers[1].push_back(row.operators);
        numbers[2].push_back(row.station);
    }
    GaugeFactors factors;
    factors.part = numberedLabels(numbers[0]);
    if (rows.front().operators >= 0)
        factors.operators = numberedLabels(numbers[1]);
    if (rows.front().station >= 0)
        factors.station = numberedLabels(numbers[2]);
    return factors;
}

inline Eigen::VectorXd valuesOf(const std::vector<GaugeRow>& rows)
{
    Eigen::VectorXd values(Eigen::Index(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        values[Eigen::Index(i)] = rows[i].value;
    return values;
}

inline GaugeMeasurements measurementsOf(const std::vector<GaugeRow>& rows)
{
    GaugeMeasurements measurements;
    measurements.factors = factorsOf(rows);
    measurements.names = QStringList{QStringLiteral("value")};
    measurements.values = valuesOf(rows);
    return measurements;
}

/// Numbers in the order in which the last index runs fastest.
inline std::vector<GaugeRow> crossedRows(int parts, int operators, int trials,
                                         const std::vector<double>& values, bool operatorsFirst = true)
{
    std::vector<GaugeRow> rows;
    for (int a = 0; a < (operatorsFirst ? operators : parts); ++a)
        for (int b = 0; b < (operatorsFirst ? parts : operators); ++b)
            for (int t = 0; t < trials; ++t)
                rows.push_back({operatorsFirst ? b : a, operatorsFirst ? a : b, -1, values[rows.size()]});
    return rows;
}

/// Draws effects of these deviations on the rows' levels: part, operator, station, part x operator,
/// part x station, repeatability.
inline void drawGaugeValues(std::vector<GaugeRow>& rows, const std::array<double, 6>& deviations,
                            std::uint64_t seed)
{
    const auto effect = [&](int source, int a, int b) {
        RandomStream random(seed, std::uint64_t(source), std::uint64_t(a + 1) * 1000 + std::uint64_t(b + 1));
        return deviations[std::size_t(source)] * random.normal();
    };
    RandomStream repeats(seed, 77, 0);
    for (GaugeRow& row : rows)
        row.value = effect(0, row.part, 0) + effect(1, row.operators, 0) + effect(2, row.station, 0) +
                    effect(3, row.part, row.operators) + effect(4, row.part, row.station) +
                    deviations[5] * repeats.normal();
}

inline std::vector<GaugeRow> drawnCrossedRows(int parts, int operators, int stations, int trials,
                                              const std::array<double, 6>& deviations, std::uint64_t seed)
{
    std::vector<GaugeRow> rows;
    for (int p = 0; p < parts; ++p)
        for (int o = 0; o < operators; ++o)
            for (int s = 0; s < std::max(stations, 1); ++s)
                for (int t = 0; t < trials; ++t)
                    rows.push_back({p, o, stations > 0 ? s : -1, 0});
    drawGaugeValues(rows, deviations, seed);
    return rows;
}

/// Leaves out a share of the rows.
inline std::vector<GaugeRow> thinned(std::vector<GaugeRow> rows, double share, std::uint64_t seed)
{
    RandomStream random(seed, 5, 5);
    std::erase_if(rows, [&](const GaugeRow&) { return random.uniform() < share; });
    return rows;
}

/// 3 prototypes x 3 operators x 3 runs, operators first.
inline std::vector<GaugeRow> prototypeRows()
{
    return crossedRows(3, 3, 3,
                       {1.27, 0.9,  1.09, 1.12, 1.09, 1.15, 1.73, 1.28, 1.77, 1.34, 1.32, 1.27, 1.24, 1,
                        1.14, 1.64, 1.65, 1.77, 1.09, 1.26, 1.09, 1.48, 1.15, 1.15, 1.64, 1.44, 1.68});
}

/// Glucose: 20 days, 2 runs of each, 2 measurements of each run; days as parts.
inline std::vector<GaugeRow> glucoseRows()
{
    return crossedRows(20, 2, 2,
                       {242, 246, 245, 246, 243, 242, 238, 238, 247, 239, 241, 240, 249, 241, 250, 245,
                        246, 242, 243, 240, 244, 245, 251, 247, 241, 246, 245, 247, 245, 245, 243, 245,
                        243, 239, 244, 245, 244, 246, 247, 239, 252, 251, 247, 241, 249, 248, 251, 246,
                        242, 240, 251, 245, 246, 249, 248, 240, 247, 248, 245, 246, 240, 238, 239, 242,
                        241, 244, 245, 248, 244, 244, 237, 242, 241, 239, 247, 245, 247, 240, 245, 242},
                       false);
}

/// 10 parts x 3 appraisers x 3 trials (AIAG, Measurement Systems Analysis), appraisers first.
inline std::vector<GaugeRow> manualRows()
{
    return crossedRows(
        10, 3, 3, {0.29,  0.41,  0.64,  -0.56, -0.68, -0.58, 1.34,  1.17,  1.27,  0.47,  0.50,  0.64,  -0.80,
                   -0.92, -0.84, 0.02,  -0.11, -0.21, 0.59,  0.75,  0.66,  -0.31, -0.20, -0.17, 2.26,  1.99,
                   2.01,  -1.36, -1.25, -1.31, 0.08,  0.25,  0.07,  -0.47, -1.22, -0.68, 1.19,  0.94,  1.34,
                   0.01,  1.03,  0.20,  -0.56, -1.20, -1.28, -0.20, 0.22,  0.06,  0.47,  0.55,  0.83,  -0.63,
                   0.08,  -0.34, 1.80,  2.12,  2.19,  -1.68, -1.62, -1.50, 0.04,  -0.11, -0.15, -1.38, -1.13,
                   -0.96, 0.88,  1.09,  0.67,  0.14,  0.20,  0.11,  -1.46, -1.07, -1.45, -0.29, -0.67, -0.49,
                   0.02,  0.01,  0.21,  -0.46, -0.56, -0.49, 1.77,  1.45,  1.87,  -1.49, -1.77, -2.16});
}

inline bool isNear(double found, double expected, double tolerance)
{
    return std::abs(found - expected) <= tolerance;
}

inline bool isRelativelyNear(double found, double expected, double tolerance)
{
    return std::abs(found - expected) <= tolerance * std::abs(expected);
}

} // namespace gripscope::test
