// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/normal_interval.h"
#include "ui/context/workbench.h"
#include "ui/format/determined_text.h"
#include "ui/format/parameter_text.h"
#include "ui/pages/enroll/enroll_squeeze_panel.h"
#include "ui/theme/theme.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

QString threeLines(const QString& k, const QString& b, const QString& m)
{
    return LiveSqueezeWords::tr("k  %1\nb  %2\nm  %3").arg(k, b, m);
}

namespace {

/// m, b and k, a dash for what was not found.
ParameterTexts linearTexts(const EnrollSqueeze& squeeze)
{
    const Recording& recording = squeeze.recording;
    if (squeeze.identification.best() != nullptr)
        return parameterTexts(squeeze.identification, recording.forceUnit, recording.positionUnit);
    ParameterTexts texts;
    texts.m.value = texts.b.value = texts.k.value = QChar(0x2013);
    const std::array places{&texts.m, &texts.b, &texts.k};
    for (const DeterminedParameter& one : determinedParameters(squeeze))
        if (const auto place = linearPlaceOf(one.parameter); place && !one.isLowerBound)
            *places[*place] = formatNumber(
                one.value,
                one.interval ? std::optional((one.interval->upper - one.interval->lower) / 2) : std::nullopt,
                one.unit);
    return texts;
}

} // namespace

QString numbersOf(const EnrollSqueeze& squeeze)
{
    const std::vector<DeterminedParameter> all = determinedParameters(squeeze);
    if (all.empty())
        return {};
    const ParameterTexts texts = linearTexts(squeeze);
    const bool isBound = all.front().isLowerBound; // then there is nothing else
    const QString lines =
        threeLines(isBound ? determinedText(all.front()) : texts.k.text(), texts.b.text(), texts.m.text());
    const QString further = furtherText(all);
    return further.isEmpty() ? lines : lines + u'\n' + further;
}

LiveSqueezeWords liveSqueezeWords(const std::optional<RecursiveState>& state, const QString& forceUnit,
                                  const QString& positionUnit)
{
    const QString none = u"–"_s;
    if (!state || !state->parameters)
        return {threeLines(none, none, none), LiveSqueezeWords::tr("Not enough of the squeeze yet.")};
    std::optional<Eigen::Vector3d> errors;
    if (state->covariance)
        errors = state->covariance->diagonal().cwiseMax(0.0).cwiseSqrt();
    const ParameterTexts texts = parameterTexts(*state->parameters, errors, forceUnit, positionUnit);
    LiveSqueezeWords words{threeLines(texts.k.text(), texts.b.text(), texts.m.text()), {}};
    const double k = state->parameters->k;
    words.quality = errors && k > 0 ? LiveSqueezeWords::tr("Stiffness known to %1 so far.")
                                          .arg(formatPercent(100 * normal95 * (*errors)[2] / k))
                                    : LiveSqueezeWords::tr("Still searching.");
    return words;
}

EnrollAdvisor::EnrollAdvisor(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(&workbench)
{
}

void EnrollAdvisor::follow()
{
    const EnrollSession& session = m_workbench->enrollment();
    AdviceRequest request = adviceRequest(session.typeName(), session.squeezes(), m_workbench->rates().rates);
    if (request == m_request)
        return;
    m_request = std::move(request);
    m_advice.reset();
    emit changed();
    if (!m_asking) // else once the answer is there
        ask();
}

void EnrollAdvisor::ask()
{
    using Squeezes = std::vector<TypeSqueeze>;
    m_asking = true;
    const AdviceRequest asked = m_request;
    const auto compute = [this, asked](const Squeezes& library) {
        m_workbench->background().compute<EnrollmentAdvice>(
            this, [asked, library] { return advise(asked, library); },
            [this, asked](EnrollmentAdvice advice) {
                m_asking = false;
                if (!(asked == m_request))
                    return ask();
                m_advice = std::move(advice);
                emit changed();
            });
    };
    m_workbench->background().ask<Squeezes>(
        this, [](Library& library) { return library.enrolledSqueezes(); },
        [this, compute](const Expected<Squeezes>& library) {
            if (library)
                return compute(*library);
            m_asking = false;
            m_workbench->messages().report(library.error().describe());
        });
}

QString validityWord(const EnrollSqueeze& squeeze)
{
    if (squeeze.identification.validity.checks.empty())
        return EnrollSqueezeModel::tr("stored");
    switch (squeeze.identification.validity.verdict) {
    case ValidityVerdict::Valid:
        return EnrollSqueezeModel::tr("valid");
    case ValidityVerdict::Suspect:
        return EnrollSqueezeModel::tr("suspect");
    case ValidityVerdict::Invalid:
        return EnrollSqueezeModel::tr("not valid");
    }
    return {};
}

EnrollSqueezeModel::Row EnrollSqueezeModel::makeRow(const EnrollSqueeze& squeeze)
{
    Row row;
    row.decision = squeeze.decision;
    row.part = squeeze.part;
    row.reason = squeeze.reason;
    row.verdict = validityWord(squeeze);
    row.fit = QChar(0x2013);
    const ParameterTexts texts = linearTexts(squeeze);
    row.stiffness = texts.k;
    row.damping = texts.b;
    row.mass = texts.m;
    const Identification& identification = squeeze.identification;
    const Estimate* const recommended = identification.find(identification.recommended);
    if (recommended != nullptr && recommended->fit.simulationPercent)
        row.fit = formatPercent(*recommended->fit.simulationPercent);
    return row;
}

bool EnrollSqueezeModel::refresh(const std::vector<EnrollSqueeze>& squeezes,
                                 const std::map<int, QString>& outliers)
{
    std::vector<Row> rows;
    rows.reserve(squeezes.size());
    for (const EnrollSqueeze& squeeze : squeezes)
        rows.push_back(makeRow(squeeze));
    for (const auto& [row, reason] : outliers)
        if (row >= 0 && static_cast<std::size_t>(row) < rows.size())
            rows[static_cast<std::size_t>(row)].outlier = reason;
    if (rows == m_rows)
        return false;
    if (rows.size() > m_rows.size() && std::equal(m_rows.begin(), m_rows.end(), rows.begin())) {
        beginInsertRows({}, static_cast<int>(m_rows.size()), static_cast<int>(rows.size()) - 1);
        m_rows = std::move(rows);
        endInsertRows();
        emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1); // a unit may be common no more
    } else if (rows.size() == m_rows.size()) {
        m_rows = std::move(rows);
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    } else {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }
    return true;
}

bool EnrollSqueezeModel::isAccepted(int row) const
{
    return row >= 0 && row < rowCount() &&
           m_rows[static_cast<std::size_t>(row)].decision == EnrollSqueeze::Decision::Accepted;
}

bool EnrollSqueezeModel::hasParts() const
{
    return std::any_of(m_rows.begin(), m_rows.end(), [](const Row& row) { return !row.part.isEmpty(); });
}

QString EnrollSqueezeModel::commonUnit(FormattedNumber Row::*column) const
{
    QString unit;
    for (const Row& row : m_rows) {
        const QString& own = (row.*column).unit;
        if (own.isEmpty() || own == unit)
            continue;
        if (!unit.isEmpty())
            return {};
        unit = own;
    }
    return unit;
}

QString EnrollSqueezeModel::text(const Row& row, int number, Column column) const
{
    const auto shown = [this, &row](FormattedNumber Row::*which) {
        return commonUnit(which).isEmpty() ? (row.*which).text() : (row.*which).number();
    };
    switch (column) {
    case Column::Number:
        return QString::number(number);
    case Column::Stiffness:
        return shown(&Row::stiffness);
    case Column::Damping:
        return shown(&Row::damping);
    case Column::Mass:
        return shown(&Row::mass);
    case Column::Part:
        return row.part;
    case Column::Fit:
        return row.fit;
    case Column::Verdict:
        switch (row.decision) {
        case EnrollSqueeze::Decision::Accepted:
            return row.outlier.isEmpty() ? tr("%1, accepted").arg(row.verdict)
                                         : tr("outlier: %1").arg(row.outlier);
        case EnrollSqueeze::Decision::Pending:
            return !row.reason.isEmpty()    ? row.reason
                   : !row.outlier.isEmpty() ? tr("to decide, an outlier: %1").arg(row.outlier)
                                            : tr("%1, to decide").arg(row.verdict);
        case EnrollSqueeze::Decision::Rejected:
            return row.reason.isEmpty() ? tr("rejected") : tr("rejected: %1").arg(row.reason);
        }
        break;
    case Column::Count:
        break;
    }
    return {};
}

QVariant EnrollSqueezeModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<Column>(index.column());
    const ThemeTokens& tokens = Theme::instance().tokens();
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.row() + 1, column);
    case Qt::ToolTipRole:
        return column == Column::Verdict ? text(row, index.row() + 1, column) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter |
                                   (column <= Column::Fit ? Qt::AlignRight : Qt::AlignLeft));
    case Qt::ForegroundRole:
        return row.decision == EnrollSqueeze::Decision::Rejected  ? tokens.secondText
               : !row.outlier.isEmpty()                           ? tokens.notValid
               : row.decision == EnrollSqueeze::Decision::Pending ? tokens.accent
                                                                  : tokens.text;
    case Qt::FontRole: {
        QFont font = Theme::font(metrics::fontBase);
        font.setStrikeOut(row.decision == EnrollSqueeze::Decision::Rejected && column < Column::Verdict);
        return font;
    }
    default:
        return {};
    }
}

QVariant EnrollSqueezeModel::head(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::AlignVCenter | (column <= static_cast<int>(Column::Fit) ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole)
        return {};
    const auto name = [this](const QString& symbol, FormattedNumber Row::*which) {
        const QString unit = commonUnit(which);
        return unit.isEmpty() ? tr("%1\n± 95 %").arg(symbol) : tr("%1 (%2)\n± 95 %").arg(symbol, unit);
    };
    switch (static_cast<Column>(column)) {
    case Column::Number:
        return tr("No.");
    case Column::Part:
        return tr("Part");
    case Column::Stiffness:
        return name(tr("k"), &Row::stiffness);
    case Column::Damping:
        return name(tr("b"), &Row::damping);
    case Column::Mass:
        return name(tr("m"), &Row::mass);
    case Column::Fit:
        return tr("Simulation\nfit");
    case Column::Verdict:
        return tr("Measurement");
    case Column::Count:
        break;
    }
    return {};
}

} // namespace gripscope
