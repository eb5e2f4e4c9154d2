// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random_stream.h"
#include "core/session/quality/kept_study.h"

#include <array>

namespace gripscope::test {

inline PlanDesign crossedDesign(int parts, const QStringList& operators, int trials)
{
    PlanDesign design;
    design.parts = numberedParts(parts);
    design.operators = operators;
    design.trials = trials;
    design.seed = 3;
    return design;
}

/// A study as if it had been made, m, b and k with deviations of parts, operators and repeats in parts of
/// each.
inline KeptStudy madeStudy(const PlanDesign& design, std::array<double, 3> spreads, std::uint64_t seed = 1)
{
    KeptStudy study;
    study.plan = makePlan(design).value();
    study.record.id = QStringLiteral("s");
    study.record.study.name = QStringLiteral("Cans");
    study.record.study.kind = toString(design.kind);
    const std::array<double, 3> centre{0.04, 43, 9990};
    for (std::size_t row = 0; row < study.plan.rows.size(); ++row) {
        const PlanRow& planned = study.plan.rows[row];
        RandomStream part(seed, std::uint64_t(planned.part), 1),
            person(seed, std::uint64_t(planned.operators), 2), repeat(seed, row, 3);
        StudyMeasurementRecord record;
        record.id = QString::number(row);
        record.stored = QDateTime(QDate(2026, 3, 1), QTime(7, 30), Qt::UTC).addSecs(qint64(row) * 20);
        record.measured.row = qint64(row);
        record.measured.outcome = QStringLiteral("measured");
        record.measured.validity = QStringLiteral("valid");
        record.measured.units = {QStringLiteral("kg"), QStringLiteral("N s/m"), QStringLiteral("N/m")};
        for (std::size_t i = 0; i < centre.size(); ++i)
            record.measured.values[i] =
                StudyValue{centre[i] * (1 + spreads[0] * part.normal() + spreads[1] * person.normal() +
                                        spreads[2] * repeat.normal()),
                           centre[i] * spreads[2]};
        study.measurements.push_back(record);
    }
    return study;
}

} // namespace gripscope::test
