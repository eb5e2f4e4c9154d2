// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/squeeze_table.h"

#include "core/base/table_lines.h"
#include "core/base/words.h"

#include <cmath>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::optional<Error> problemOf(const SqueezeColumns& columns)
{
    if (columns.parameters.size() != 3)
        return Error{ErrorCode::Usage,
                     {Words::say("Mass, damping and stiffness need a column each: three names.")}};
    if (!columns.deviations.isEmpty() && columns.deviations.size() != 3)
        return Error{ErrorCode::Usage,
                     {Words::say("The errors of m, b and k need a column each: three names.")}};
    if (columns.type.isEmpty() && columns.typeName.trimmed().isEmpty())
        return Error{ErrorCode::Usage, {Words::say("Neither a type nor a column with types is named.")}};
    return {};
}

/// Reads the fields of one row.
class RowReader {
public:
    RowReader(QString file, const SqueezeColumns& columns, std::vector<qsizetype> places, qsizetype fields)
        : m_file(std::move(file)), m_columns(columns), m_places(std::move(places)), m_fields(fields)
    {
    }

    SqueezeRow read(const TableLine& line)
    {
        SqueezeRow row;
        row.line = line.number;
        m_row = &row;
        if (line.fields.size() != m_fields) {
            refuse(std::min(line.fields.size(), m_fields), Words::say("%1 fields").arg(line.fields.size()),
                   Words::say("%1, as in the header").arg(m_fields));
            return row;
        }
        row.squeeze.type =
            m_columns.type.isEmpty() ? m_columns.typeName.trimmed() : line.fields[m_places.back()];
        if (row.squeeze.type.isEmpty())
            refuse(m_places.back(), Words::say("nothing"), Words::say("the name of a type"));
        const Eigen::Vector3d parameters = numbers(line, 0, false);
        row.squeeze.parameters = {parameters(0), parameters(1), parameters(2)};
        if (!m_columns.deviations.isEmpty()) {
            const Eigen::Vector3d squares = numbers(line, 3, true).cwiseAbs2();
            row.squeeze.covariance = Eigen::Matrix3d(squares.asDiagonal());
        }
        return row;
    }

private:
    /// The first reason counts.
    void refuse(qsizetype column, const Finding& found, const Finding& expected)
    {
        if (!m_row->refused)
            m_row->refused = TablePlace{m_file, m_row->line, column + 1}.error(found, expected).value();
    }

    Eigen::Vector3d numbers(const TableLine& line, std::size_t first, bool zeroAllowed)
    {
        // Squares of larger ones would not be finite.
        constexpr double largest = 1e150;
        Eigen::Vector3d result = Eigen::Vector3d::Ones();
        for (std::size_t i = 0; i < 3; ++i) {
            const qsizetype column = m_places[first + i];
            bool ok = false;
            const double value = line.fields[column].toDouble(&ok);
            if (ok && (value > 0 || (zeroAllowed && value == 0)) && value < largest)
                result(Eigen::Index(i)) = value;
            else
                refuse(column, u"\"%1\""_s.arg(line.fields[column]),
                       zeroAllowed ? Words::say("a standard error, zero or above")
                                   : Words::say("a number above zero"));
        }
        return result;
    }

    QString m_file;
    const SqueezeColumns& m_columns;
    std::vector<qsizetype> m_places;
    qsizetype m_fields;
    SqueezeRow* m_row = nullptr;
};

} // namespace

Expected<std::vector<SqueezeRow>> parseSqueezeTable(const QByteArray& text, const QString& name,
                                                    const SqueezeColumns& columns)
{
    RETURN_IF_ERROR(problemOf(columns));
    ASSIGN_OR_RETURN(const std::vector<TableLine> lines, splitTable(text, name));
    QStringList wanted = columns.parameters + columns.deviations;
    if (!columns.type.isEmpty())
        wanted << columns.type;
    ASSIGN_OR_RETURN(const std::vector<qsizetype> places, findTableColumns(lines, wanted, name));
    RowReader reader(name, columns, places, lines.front().fields.size());
    std::vector<SqueezeRow> rows;
    rows.reserve(lines.size() - 1);
    for (std::size_t i = 1; i < lines.size(); ++i)
        rows.push_back(reader.read(lines[i]));
    return rows;
}

Expected<std::vector<SqueezeRow>> readSqueezeTable(const QString& file, const SqueezeColumns& columns)
{
    ASSIGN_OR_RETURN(const QByteArray text, readTableFile(file));
    return parseSqueezeTable(text, file, columns);
}

} // namespace gripscope
