// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/profile/field_values.h"
#include "ui/profiles/profile_dialog.h"
#include "ui/theme/theme.h"

#include <QLocale>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString hex(std::uint8_t byte)
{
    return u"%1"_s.arg(byte, 2, 16, QLatin1Char('0')).toUpper();
}

} // namespace

void ByteTableModel::setBytes(const ReportStatistics& seen)
{
    const bool another = seen.bytes().size() != m_seen.bytes().size();
    if (another)
        beginResetModel();
    m_seen = seen;
    if (another)
        endResetModel();
    else if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void ByteTableModel::setProfile(const std::optional<GripperProfile>& profile)
{
    m_profile = profile;
    setBytes(m_seen);
}

void ByteTableModel::setChosenField(const QString& name)
{
    m_chosen = name;
    setBytes(m_seen);
}

QString ByteTableModel::owners(std::size_t byte) const
{
    return m_profile ? ownersOfByte(*m_profile, byte) : QString();
}

bool ByteTableModel::chosen(std::size_t byte) const
{
    if (m_chosen.isEmpty())
        return false;
    for (const QString& owner : owners(byte).split(u", "_s))
        if (owner.section(u' ', 0, 0) == m_chosen)
            return true;
    return false;
}

QString ByteTableModel::text(std::size_t byte, Column column) const
{
    const ByteStatistics& seen = m_seen.bytes()[byte];
    switch (column) {
    case Column::Byte:
        return (seen.moves() ? u"● "_s : u"   "_s) + QString::number(byte);
    case Column::Last:
        return hex(seen.last);
    case Column::Least:
        return hex(seen.least);
    case Column::Most:
        return hex(seen.most);
    case Column::Changes:
        return seen.moves() ? QLocale().toString(m_seen.changesPerSecond(byte), 'f', 1) : u"–"_s;
    case Column::Field:
        return (chosen(byte) ? u"◀ "_s : QString()) + owners(byte);
    }
    return {};
}

QVariant ByteTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const auto byte = static_cast<std::size_t>(index.row());
    const auto column = static_cast<Column>(index.column());
    const ByteStatistics& seen = m_seen.bytes()[byte];
    const ThemeTokens& tokens = Theme::instance().tokens();
    switch (role) {
    case Qt::DisplayRole:
        return text(byte, column);
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignVCenter | (column == Column::Field ? Qt::AlignLeft : Qt::AlignRight));
    case Qt::FontRole:
        return Theme::font(metrics::fontBase, seen.moves());
    case Qt::ForegroundRole:
        return seen.moves() ? tokens.text : tokens.secondText;
    case Qt::BackgroundRole:
        return chosen(byte) ? QVariant(Theme::mix(tokens.surface, tokens.accent, 0.2)) : QVariant();
    case Qt::AccessibleTextRole:
        return column == Column::Byte
                   ? tr("Byte %1, %2").arg(byte).arg(seen.moves() ? tr("moves") : tr("rests"))
                   : QVariant();
    default:
        return {};
    }
}

QVariant ByteTableModel::head(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    switch (static_cast<Column>(column)) {
    case Column::Byte:
        return tr("Byte");
    case Column::Last:
        return tr("Last");
    case Column::Least:
        return tr("Least");
    case Column::Most:
        return tr("Most");
    case Column::Changes:
        return tr("per s");
    case Column::Field:
        return tr("Belongs to");
    }
    return {};
}

} // namespace gripscope
