// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/subgroups.h"

#include <QFile>
#include <QString>

namespace gripscope::test {

/// The piston rings of Montgomery's Introduction to Statistical Quality Control: 40 subgroups of 5, of which
/// the first 25 are phase 1. Empty where the file is not there.
struct PistonRings {
    std::vector<double> diameters;
    std::vector<int> samples; ///< from 0
    std::size_t phaseOne = 0; ///< subgroups
};

inline PistonRings readPistonRings()
{
    PistonRings rings;
    QFile file(QStringLiteral(GRIPSCOPE_SHARED_DATA "/quality/piston_rings.txt"));
    if (!file.open(QIODevice::ReadOnly))
        return rings;
    const QStringList lines = QString::fromUtf8(file.readAll()).split(u'\n', Qt::SkipEmptyParts);
    for (const QString& line : lines.mid(1)) { // diameter sample trial
        const QStringList cells = line.simplified().split(u' ');
        rings.diameters.push_back(cells[0].toDouble());
        rings.samples.push_back(cells[1].toInt() - 1);
        if (cells[2] == QStringLiteral("TRUE"))
            rings.phaseOne = std::size_t(rings.samples.back()) + 1;
    }
    return rings;
}

} // namespace gripscope::test
