// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/enrollment.h"

#include "app/cli/library/type_library.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "core/library/people/people_register.h"
#include "core/session/enroll/enrollment_storage.h"

#include <QJsonArray>
#include <QMap>

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

NewGrasp graspOf(const SqueezeRow& row, const TableEnrollment& task, const QString& source)
{
    Estimate estimate;
    estimate.estimator = Estimator::Arx; // what the paper's tables were found with; a table does not say
    estimate.status = EstimateStatus::Converged;
    estimate.message = u"From a table of m, b and k, which does not say how they were found."_s;
    estimate.parameters = row.squeeze.parameters;
    estimate.covariance = row.squeeze.covariance;
    NewGrasp grasp;
    grasp.estimates = {estimate};
    grasp.forceUnit = task.forceUnit;
    grasp.positionUnit = task.positionUnit;
    grasp.source = source;
    grasp.operatorName = task.acting.operatorName;
    return grasp;
}

/// Rows on their way into a library.
class TableWriter {
public:
    TableWriter(Library& library, const TableEnrollment& task) : m_library(library), m_task(task) {}

    /// Why the row was refused; empty when it was added.
    QString add(const SqueezeRow& row)
    {
        if (row.refused) {
            m_exit.add(Exit::BadInput);
            return row.refused->describe();
        }
        const QString source = u"%1:%2"_qs.arg(m_task.table).arg(row.line);
        const QString& type = row.squeeze.type;
        const Expected<bool> known = isKnown(type, source, row.squeeze.parameters);
        if (!known)
            return refused(known.error());
        if (*known) {
            m_exit.add(Exit::BadInput);
            return u"This row is a squeeze of the type already."_qs;
        }
        const Expected<StoredSqueeze> stored =
            storeSqueeze(m_library, {type, recipeOfNewTypes(), graspOf(row, m_task, source)});
        if (!stored)
            return refused(stored.error());
        m_added[type] += 1;
        return {};
    }

    /// Those types that got squeezes, at the end.
    void approve()
    {
        for (const QString& type : m_added.keys())
            if (const Expected<bool> done = approveEnrolled(m_library, type, m_task.acting.operatorName);
                !done)
                message(u"gripscope-cli: "_qs + refused(done.error()));
    }
    [[nodiscard]] ExitCode exit() const { return m_exit; }
    [[nodiscard]] const QMap<QString, int>& added() const { return m_added; }

private:
    QString refused(const Error& error)
    {
        m_exit.add(exitFor(error));
        return error.describe();
    }

    Expected<bool> isKnown(const QString& type, const QString& source, const MassDampingStiffness& p)
    {
        if (!m_present.contains(type)) {
            ASSIGN_OR_RETURN(StoredType stored, findStoredType(m_library, type));
            m_present[type] = std::move(stored.grasps);
        }
        const std::vector<GraspRecord>& grasps = m_present[type];
        return std::any_of(grasps.begin(), grasps.end(), [&](const GraspRecord& grasp) {
            return grasp.accepted && grasp.source == source && grasp.forceUnit == m_task.forceUnit &&
                   grasp.positionUnit == m_task.positionUnit && grasp.parameters &&
                   grasp.parameters->vector() == p.vector();
        });
    }

    Library& m_library;
    const TableEnrollment& m_task;
    QMap<QString, std::vector<GraspRecord>> m_present; ///< by type, as they were before this table
    QMap<QString, int> m_added;
    ExitCode m_exit;
};

QJsonArray typesJson(const QMap<QString, int>& added)
{
    QJsonArray types;
    for (auto it = added.cbegin(); it != added.cend(); ++it)
        types.append(QJsonObject{{u"type"_qs, it.key()}, {u"added"_qs, it.value()}});
    return types;
}

} // namespace

Expected<bool> approveEnrolled(Library& library, const QString& type, const QString& operatorName)
{
    ASSIGN_OR_RETURN(const bool people, library.people().inForce());
    if (people) {
        message(u"%1 is not approved: its parts are not recognised until a supervisor approves it with "
                "\"types approve\"."_qs.arg(type));
        return false;
    }
    ASSIGN_OR_RETURN(const TypeRecord record, requireNamed(library, type));
    RETURN_IF_ERROR(library.approveType(record.id, operatorName));
    message(u"%1 is approved: its parts are recognised."_qs.arg(type));
    return true;
}

int enrollTable(const TableEnrollment& task, const QString& libraryFile, bool json)
{
    const Expected<std::vector<SqueezeRow>> rows = readSqueezeTable(task.table, task.columns);
    if (!rows)
        return fail(rows.error(), json);
    const Expected<std::unique_ptr<Library>> library = Library::open(libraryFile);
    if (!library)
        return fail(library.error(), json);
    (*library)->actAs(task.acting);
    TableWriter writer(**library, task);
    QJsonArray added, refused;
    for (const SqueezeRow& row : *rows) {
        const QString place = u"%1:%2"_qs.arg(task.table).arg(row.line);
        const QString reason = writer.add(row);
        if (reason.isEmpty()) {
            added.append(place);
            continue;
        }
        message(u"rejected %1: %2"_qs.arg(place, reason));
        refused.append(QJsonObject{{u"file"_qs, place}, {u"reason"_qs, reason}});
    }
    writer.approve();
    if (json)
        printJson({{u"table"_qs, task.table},
                   {u"types"_qs, typesJson(writer.added())},
                   {u"added"_qs, added},
                   {u"rejected"_qs, refused}});
    else
        print(u"%1: %2 squeezes of %3 types added, %4 rows rejected."_qs.arg(task.table)
                  .arg(added.size())
                  .arg(writer.added().size())
                  .arg(refused.size()));
    return writer.exit().value();
}

} // namespace gripscope::cli
