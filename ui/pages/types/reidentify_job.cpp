// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/enroll/enrollment_storage.h"
#include "ui/context/workbench.h"
#include "ui/format/estimate_words.h"
#include "ui/format/history_words.h"
#include "ui/format/number_format.h"
#include "ui/format/parameter_text.h"
#include "ui/pages/types/reidentify_dialog.h"

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

struct Stored {
    HistoryEntry entry;
    Expected<Recording> recording;
};

Expected<Stored> fetch(Library& library, const QString& graspId)
{
    ASSIGN_OR_RETURN(auto entries, library.historyEntries({graspId}));
    if (entries.empty())
        return failure(ErrorCode::NotFound, {graspId});
    return Stored{std::move(entries.front()), library.recording(graspId)};
}

/// The object alone, the empty gripper taken off, as it is stored for squeezes of the first time.
Estimate reidentify(const Recording& recording, Estimator estimator, const Reidentification& how)
{
    IdentificationOptions options;
    options.estimators = {estimator};
    options.hold = how.hold;
    options.initialState = how.initialState;
    options.freeOffset = how.freeOffset;
    options.assess = false;
    const Identification found = identify(recording, options);
    NewGrasp grasp = makeGrasp(recording, found, {}, {});
    Estimate estimate = grasp.estimates.empty() ? Estimate() : std::move(grasp.estimates.front());
    estimate.simulated.clear();
    estimate.residual.clear();
    return estimate;
}

} // namespace

ReidentifyJob::ReidentifyJob(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(&workbench)
{
}

void ReidentifyJob::start(std::vector<QString> graspIds, Estimator estimator, const Reidentification& how)
{
    m_ids = std::move(graspIds);
    m_results.clear();
    m_estimator = estimator;
    m_how = how;
    m_cancelled = false;
    m_running = true;
    next();
}

void ReidentifyJob::cancel()
{
    m_cancelled = true;
}

void ReidentifyJob::next()
{
    if (m_cancelled || m_results.size() >= m_ids.size()) {
        m_running = false;
        emit ended();
        return;
    }
    m_workbench->background().ask<Stored>(
        this, [id = m_ids[m_results.size()]](Library& library) { return fetch(library, id); },
        [this](Expected<Stored> stored) {
            if (!stored)
                return take({{}, {}, stored.error().describe()});
            if (!stored->recording)
                return take({stored->entry,
                             {},
                             stored->recording.error().code == ErrorCode::NotFound
                                 ? tr("no recording was stored with it")
                                 : stored->recording.error().describe()});
            m_workbench->background().compute<Estimate>(
                this,
                [recording = std::move(*stored->recording), estimator = m_estimator, how = m_how] {
                    return reidentify(recording, estimator, how);
                },
                [this, entry = stored->entry](Estimate estimate) {
                    const QString trouble = estimate.parameters ? QString() : estimate.message.describe();
                    take({entry, std::move(estimate), trouble});
                });
        });
}

void ReidentifyJob::take(ReidentifiedSqueeze squeeze)
{
    m_results.push_back(std::move(squeeze));
    emit progressed();
    next();
}

using ReidentifyColumn = ReidentifyModel::Column;

namespace {

const QString dash(QChar(0x2013));

double component(const MassDampingStiffness& p, ReidentifyColumn column)
{
    return column == ReidentifyColumn::Mass ? p.m : column == ReidentifyColumn::Damping ? p.b : p.k;
}

FormattedNumber component(const ParameterTexts& texts, ReidentifyColumn column)
{
    return column == ReidentifyColumn::Mass      ? texts.m
           : column == ReidentifyColumn::Damping ? texts.b
                                                 : texts.k;
}

/// Of what was found from what is stored, relative.
std::optional<double> deviation(const ReidentifiedSqueeze& row, ReidentifyColumn column)
{
    const auto& before = row.entry.parameters;
    if (!before || !row.estimate || !row.estimate->parameters || component(*before, column) == 0)
        return {};
    return component(*row.estimate->parameters, column) / component(*before, column) - 1;
}

/// "9.98 → 9.91 kN/m", the deviation below.
QString parameterText(const ReidentifiedSqueeze& row, ReidentifyColumn column)
{
    const HistoryEntry& entry = row.entry;
    if (!row.estimate || !row.estimate->parameters)
        return column == ReidentifyColumn::Mass ? row.trouble : QString();
    const QString now =
        component(parameterTexts(*row.estimate, entry.forceUnit, entry.positionUnit), column).text();
    if (!entry.parameters)
        return now;
    const QString before = component(parameterTexts(*entry.parameters, entry.standardErrors, entry.forceUnit,
                                                    entry.positionUnit),
                                     column)
                               .text();
    const std::optional<double> share = deviation(row, column);
    return u"%1\n%2 (%3)"_s.arg(before, now, share ? deviationText(*share) : dash);
}

} // namespace

void ReidentifyModel::clear()
{
    beginResetModel();
    m_rows.clear();
    endResetModel();
}

void ReidentifyModel::append(const ReidentifiedSqueeze& squeeze)
{
    const int row = int(m_rows.size());
    beginInsertRows({}, row, row);
    m_rows.push_back(squeeze);
    endInsertRows();
}

QString ReidentifyModel::text(const ReidentifiedSqueeze& row, ReidentifyColumn column)
{
    const auto fit = [](const std::optional<double>& percent) {
        return percent ? formatPercent(*percent) : dash;
    };
    switch (column) {
    case ReidentifyColumn::Squeeze:
        return HistoryWords::title(row.entry);
    case ReidentifyColumn::Fit:
        return u"%1\n%2"_s.arg(fit(row.entry.simulationFitPercent),
                               fit(row.estimate ? row.estimate->fit.simulationPercent : std::nullopt));
    case ReidentifyColumn::Mass:
    case ReidentifyColumn::Damping:
    case ReidentifyColumn::Stiffness:
        break;
    }
    return parameterText(row, column);
}

QVariant ReidentifyModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const ReidentifiedSqueeze& row = m_rows[std::size_t(index.row())];
    const auto column = ReidentifyColumn(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::EditRole: {
        const std::optional<double> share =
            column == ReidentifyColumn::Squeeze || column == ReidentifyColumn::Fit ? std::nullopt
                                                                                   : deviation(row, column);
        return share ? QVariant(*share) : QVariant();
    }
    case Qt::ToolTipRole:
        return row.trouble;
    default:
        return {};
    }
}

QVariant ReidentifyModel::head(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    switch (ReidentifyColumn(column)) {
    case ReidentifyColumn::Squeeze:
        return tr("Squeeze");
    case ReidentifyColumn::Mass:
        return tr("m: stored, now");
    case ReidentifyColumn::Damping:
        return tr("b: stored, now");
    case ReidentifyColumn::Stiffness:
        return tr("k: stored, now");
    case ReidentifyColumn::Fit:
        return tr("Simulation fit");
    }
    return {};
}

} // namespace gripscope
