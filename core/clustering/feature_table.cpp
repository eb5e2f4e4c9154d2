// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/feature_table.h"

#include "core/base/table_lines.h"
#include "core/base/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<FeatureTable> parseFeatureTable(const QByteArray& text, const QString& name,
                                         const QStringList& features, const QString& truthColumn)
{
    if (features.isEmpty())
        return failure(ErrorCode::Usage, {Words::say("No feature is named.")});
    ASSIGN_OR_RETURN(const auto lines, splitTable(text, name));
    const TableLine& header = lines.front();
    ASSIGN_OR_RETURN(const auto columns,
                     findTableColumns(lines,
                                      truthColumn.isEmpty() ? features : features + QStringList{truthColumn},
                                      name));

    FeatureTable table;
    table.features = features;
    table.values.resize(Eigen::Index(lines.size()) - 1, features.size());
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const TableLine& line = lines[i];
        if (line.fields.size() != header.fields.size())
            return TablePlace{name, line.number, std::min(line.fields.size(), header.fields.size()) + 1}
                .error(u"%1 fields"_s.arg(line.fields.size()),
                       Words::say("%1, as in the header").arg(header.fields.size()));
        for (qsizetype j = 0; j < features.size(); ++j) {
            const qsizetype column = columns[std::size_t(j)];
            bool ok = false;
            const double value = line.fields[column].toDouble(&ok);
            if (!ok || !std::isfinite(value))
                return TablePlace{name, line.number, column + 1}.error(u"\"%1\""_s.arg(line.fields[column]),
                                                                       Words::say("a finite number"));
            table.values(Eigen::Index(i) - 1, j) = value;
        }
        if (!truthColumn.isEmpty())
            table.truth.append(line.fields[columns.back()]);
    }
    return table;
}

Expected<FeatureTable> readFeatureTable(const QString& file, const QStringList& features,
                                        const QString& truthColumn)
{
    ASSIGN_OR_RETURN(const QByteArray text, readTableFile(file));
    return parseFeatureTable(text, file, features, truthColumn);
}

} // namespace gripscope
