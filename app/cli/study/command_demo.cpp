// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/drive.h"
#include "app/cli/line/output.h"
#include "core/library/ledger/library_witness.h"
#include "core/session/enroll/enroll_session.h"
#include "core/session/inspect/inspect_session.h"
#include "devices/factory/gripper_factory.h"

#include <QMap>
#include <QTemporaryDir>

#include <array>
#include <cstdint>
#include <functional>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Counts of a demonstration, as they fell.
struct DemoCounts {
    int enrolled = 0;
    int tested = 0, correct = 0, wrongType = 0, unknown = 0;
    int strangers = 0, strangersUnknown = 0;
    QMap<QString, QMap<QString, int>> confusion; ///< true object -> what the verdict named -> how often
};

/// Longer than anything in here takes.
constexpr double demoPatience_s = 60;
constexpr int squeezesPerType = 10;
/// A squeeze whose measurement turns out invalid is repeated, as a technician would; so often at most.
constexpr int attemptsPerSqueeze = 3;

struct TestedObject {
    QString name, object;
    int squeezes;
};

/// The stranger is a half-filled can: half as heavy again as A, with more damping and a stiffer wall, m, b, k
/// in SI. That is 10, 9 and 5 times the scatter between squeezes away from A, the nearest type, whatever the
/// seed.
const std::array<TestedObject, 5>& testedObjects()
{
    static const std::array<TestedObject, 5> objects{{{u"A"_qs, u"A"_qs, 8},
                                                      {u"B"_qs, u"B"_qs, 8},
                                                      {u"C"_qs, u"C"_qs, 7},
                                                      {u"D"_qs, u"D"_qs, 7},
                                                      {u"stranger"_qs, u"0.060,60,12000"_qs, 5}}};
    return objects;
}

Error stuck(const QString& what)
{
    return {ErrorCode::DeviceTimeout, {what, QString::number(demoPatience_s)}};
}

/// One gripper, one library, and the two sessions that a person would use.
class Demonstration {
public:
    Demonstration(std::uint64_t seed, const QString& library)
        : m_seed(seed), m_library(library), m_connection(m_devices), m_enrollment(m_connection, m_library),
          m_inspection(m_connection, m_library)
    {
        m_enrollment.setOperator(u"demo"_qs);
        m_inspection.setOperator(u"demo"_qs);
        m_inspection.setEarlyEnd(
            false); // at full speed the whole squeeze is there before it could be decided
    }

    std::optional<Error> enroll(const QString& type);
    std::optional<Error> prepareInspections();
    Expected<Verdict> inspect(const QString& object);
    [[nodiscard]] int enrolled() const { return m_enrolled; }

private:
    std::optional<Error> connectTo(const QString& object);
    std::optional<Error> enrollOne(const QString& type);
    std::optional<Error> settle(const Expected<void>& asked);

    std::uint64_t m_seed;
    std::uint64_t m_squeeze = 0;
    int m_enrolled = 0;
    DeviceFactory m_devices;
    LibraryService m_library;
    ConnectSession m_connection;
    EnrollSession m_enrollment;
    InspectSession m_inspection;
};

/// A gripper of its own for each squeeze, its seed from the demonstration's and the squeeze's number.
std::optional<Error> Demonstration::connectTo(const QString& object)
{
    const std::uint64_t seed = m_seed * 1000 + ++m_squeeze;
    const QString address = u"virtual:?object=%1&seed=%2&speed=0"_qs.arg(object, QString::number(seed));
    if (const Expected<void> asked = m_connection.connectTo(address); !asked)
        return asked.error();
    const auto poll = [this] { m_connection.poll(); };
    if (!drive(
            poll, [this] { return m_connection.state() != ConnectSession::State::Connecting; },
            demoPatience_s))
        return stuck(u"open"_qs);
    if (m_connection.state() != ConnectSession::State::Connected)
        return m_connection.lastError();
    if (const Expected<void> asked = m_connection.arm(u"demo"_qs); !asked)
        return asked.error();
    if (!drive(
            poll, [this] { return m_connection.armed(); }, demoPatience_s))
        return stuck(u"arm"_qs);
    return std::nullopt;
}

/// Waits until the enrolment wants something of a person again.
std::optional<Error> Demonstration::settle(const Expected<void>& asked)
{
    using Activity = EnrollSession::Activity;
    if (!asked)
        return asked.error();
    const bool settled = drive(
        [this] {
            m_connection.poll();
            m_enrollment.poll();
        },
        [this] {
            return m_enrollment.activity() == Activity::Waiting ||
                   m_enrollment.activity() == Activity::Deciding;
        },
        demoPatience_s);
    return settled ? m_enrollment.lastError() : stuck(u"finish an enrolment"_qs);
}

std::optional<Error> Demonstration::enrollOne(const QString& type)
{
    for (int attempt = 0; attempt < attemptsPerSqueeze; ++attempt) {
        if (const std::optional<Error> error = connectTo(type))
            return error;
        if (const std::optional<Error> error = settle(m_enrollment.squeeze()))
            return error;
        if (const QString advice = m_enrollment.squeezes().back().reason; !advice.isEmpty()) {
            (void)m_enrollment.reject(advice);
            continue;
        }
        if (const std::optional<Error> error = settle(m_enrollment.accept()))
            return error;
        ++m_enrolled;
        return std::nullopt;
    }
    return Error{ErrorCode::DeviceRefused,
                 {u"give a valid squeeze"_qs, m_enrollment.squeezes().back().reason}};
}

std::optional<Error> Demonstration::enroll(const QString& type)
{
    m_enrollment.restart();
    if (const Expected<void> named = m_enrollment.setName(type); !named)
        return named.error();
    if (const std::optional<Error> error = settle(m_enrollment.setRecipe({})))
        return error;
    for (int i = 0; i < squeezesPerType; ++i)
        if (const std::optional<Error> error = enrollOne(type))
            return error;
    if (const Expected<void> reviewed = m_enrollment.review(); !reviewed)
        return reviewed.error();
    return settle(m_enrollment.approve());
}

std::optional<Error> Demonstration::prepareInspections()
{
    m_inspection.reload();
    const bool ready = drive(
        [this] { m_inspection.poll(); },
        [this] { return m_inspection.state() == InspectSession::State::Ready || m_inspection.lastError(); },
        demoPatience_s);
    return ready ? m_inspection.lastError() : stuck(u"read the library"_qs);
}

Expected<Verdict> Demonstration::inspect(const QString& object)
{
    RETURN_IF_ERROR(connectTo(object));
    RETURN_IF_ERROR(m_inspection.squeeze());
    const bool judged = drive(
        [this] {
            m_connection.poll();
            m_inspection.poll();
        },
        [this] { return m_inspection.state() == InspectSession::State::Ready && !m_inspection.storing(); },
        demoPatience_s);
    if (!judged)
        return tl::unexpected<Error>(stuck(u"finish an inspection"_qs));
    RETURN_IF_ERROR(m_inspection.lastError());
    return m_inspection.result()->verdict;
}

void count(DemoCounts& counts, const TestedObject& tested, const Verdict& verdict)
{
    const QString named = verdict.kind == VerdictKind::Type ? verdict.type : toString(verdict.kind);
    ++counts.confusion[tested.name][named];
    const bool unknown = verdict.kind == VerdictKind::Unknown;
    if (tested.name == u"stranger"_qs) {
        ++counts.strangers;
        counts.strangersUnknown += unknown;
        return;
    }
    ++counts.tested;
    counts.unknown += unknown;
    counts.correct += named == tested.name;
    counts.wrongType += verdict.kind == VerdictKind::Type && named != tested.name;
}

/// The whole chain on the virtual gripper, as fast as it can: 10 squeezes of each of the 4 cans enrolled, 30
/// unseen ones and 5 of a stranger inspected. Every squeeze is another one of its can, from a seed of its
/// own. The library is a temporary file. `progress` is told what is being done.
Expected<DemoCounts> runDemonstration(std::uint64_t seed, const std::function<void(const QString&)>& progress)
{
    const QTemporaryDir folder;
    if (!folder.isValid())
        return failure(ErrorCode::FileUnwritable, {folder.path(), folder.errorString()});
    const PassingLibrary library(folder.filePath(u"demo.gripscope"_qs));
    Demonstration demonstration(seed, library.file());
    DemoCounts counts;
    for (const QString& type : {u"A"_qs, u"B"_qs, u"C"_qs, u"D"_qs}) {
        progress(u"enrolling %1"_qs.arg(type));
        RETURN_IF_ERROR(demonstration.enroll(type));
    }
    counts.enrolled = demonstration.enrolled();
    RETURN_IF_ERROR(demonstration.prepareInspections());
    for (const TestedObject& tested : testedObjects()) {
        progress(u"inspecting %1"_qs.arg(tested.name));
        for (int i = 0; i < tested.squeezes; ++i) {
            ASSIGN_OR_RETURN(const Verdict verdict, demonstration.inspect(tested.object));
            count(counts, tested, verdict);
        }
    }
    return counts;
}

QJsonObject document(std::uint64_t seed, const DemoCounts& counts)
{
    QJsonObject confusion;
    for (auto row = counts.confusion.cbegin(); row != counts.confusion.cend(); ++row) {
        QJsonObject cells;
        for (auto cell = row.value().cbegin(); cell != row.value().cend(); ++cell)
            cells[cell.key()] = cell.value();
        confusion[row.key()] = cells;
    }
    return {{u"seed"_qs, static_cast<qint64>(seed)},
            {u"enrolled"_qs, counts.enrolled},
            {u"tested"_qs, counts.tested},
            {u"correct"_qs, counts.correct},
            {u"wrong_type"_qs, counts.wrongType},
            {u"unknown"_qs, counts.unknown},
            {u"strangers"_qs, counts.strangers},
            {u"strangers_unknown"_qs, counts.strangersUnknown},
            {u"confusion"_qs, confusion}};
}

QString text(std::uint64_t seed, const DemoCounts& counts)
{
    QStringList lines{
        u"Virtual gripper, seed %1: %2 squeezes of 4 types enrolled."_qs.arg(seed).arg(counts.enrolled),
        u"%1 unseen squeezes: %2 right, %3 wrong type, %4 unknown."_qs.arg(counts.tested)
            .arg(counts.correct)
            .arg(counts.wrongType)
            .arg(counts.unknown),
        u"%1 squeezes of a stranger: %2 unknown."_qs.arg(counts.strangers).arg(counts.strangersUnknown)};
    for (auto row = counts.confusion.cbegin(); row != counts.confusion.cend(); ++row) {
        QString line = u"  %1"_qs.arg(row.key(), -10);
        for (auto cell = row.value().cbegin(); cell != row.value().cend(); ++cell)
            line += u"  %1: %2"_qs.arg(cell.key()).arg(cell.value());
        lines << line;
    }
    return lines.join(u'\n');
}

} // namespace

int runDemo(const QStringList& arguments)
{
    CommandLine line(
        u"demo"_qs,
        u"Enrols 4 types with 10 squeezes each on the virtual gripper, then inspects 30 unseen squeezes and "
        "5 of a half-filled can that was never enrolled."_qs);
    line.option(u"seed"_qs, u"N"_qs, u"Seed of all squeezes."_qs, u"1"_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const std::uint64_t seed = line.seed();
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    const Expected<DemoCounts> counts = runDemonstration(seed, message);
    if (!counts)
        return fail(counts.error(), json);
    if (json)
        printJson(document(seed, *counts));
    else
        print(text(seed, *counts));
    return 0;
}

} // namespace gripscope::cli
