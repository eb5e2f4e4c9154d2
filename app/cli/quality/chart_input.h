// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/quality/quality_commands.h"
#include "core/quality/charts/subgroups.h"
#include "core/session/process/process_chart.h"

namespace gripscope::cli {

/// What a chart, or a capability, is of: the columns of a table, or, with --type, the inspections of a
/// library in which that type was recognised, of which a million are read in a second.
class ChartInput {
public:
    /// `values`: the columns that will be asked for. Of inspections those that determine all of them.
    [[nodiscard]] static Expected<ChartInput> read(const CommandLine& line, const QStringList& values);

    [[nodiscard]] std::size_t rows() const;
    /// BadInput for a column that is not there.
    [[nodiscard]] Expected<std::vector<double>> numbers(const QString& column) const;
    /// `text` of --subgroup: a column, whose rows with the same entry belong together, or how many rows in a
    /// row; empty: each row by itself. Usage for what is neither.
    [[nodiscard]] Expected<SubgroupLayout> layout(const QString& text) const;

private:
    [[nodiscard]] static Expected<ChartInput> ofInspections(const CommandLine& line,
                                                            const QStringList& values);
    [[nodiscard]] QStringList columns() const;
    [[nodiscard]] Expected<SubgroupLayout> byColumn(const QString& column) const;

    std::optional<StudyTable> m_table;
    ProcessValues m_values; ///< without a table
    ProcessRows m_rows;
};

/// addTableOptions(), and what --type may be narrowed by.
void addChartTableOptions(CommandLine& line);

} // namespace gripscope::cli
