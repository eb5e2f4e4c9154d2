// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/line_report.h"

#include "core/session/line/line_session.h"

namespace gripscope {

using namespace Qt::StringLiterals;

bool isSimulated(const QString& address)
{
    return address.startsWith("virtual:"_L1) || address.startsWith("replay:"_L1);
}

LineReporter::LineReporter(const ConnectSession& connection, const InspectSession& inspection)
    : m_connection(connection), m_inspection(inspection),
      m_told(inspection.result() ? inspection.result()->squeeze : 0)
{
}

std::optional<LineReport> LineReporter::next()
{
    const auto& result = m_inspection.result();
    if (!result || result->squeeze == m_told || m_inspection.state() == InspectSession::State::Judging)
        return {};
    m_told = result->squeeze;
    LineReport report;
    report.gripper = result->recording.provenance.value(u"serial"_s);
    if (report.gripper.isEmpty())
        return {}; // a recording that was judged, and no squeeze of a gripper
    report.part = result->partNumber;
    report.expectedType = result->expectedType;
    if (result->verdict.kind == VerdictKind::Type)
        report.typeFound = result->verdict.type;
    report.result = lineResult(*result, {});
    report.result.simulated = isSimulated(m_connection.address());
    return report;
}

QString LineReporter::gripper() const
{
    return m_connection.state() == ConnectSession::State::Connected ? m_connection.identity().serial
                                                                    : QString();
}

} // namespace gripscope
