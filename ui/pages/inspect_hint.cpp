// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect_hint.h"

#include "ui/connection_words.h"
#include "ui/workbench.h"

#include <QCoreApplication>

namespace gripscope {

namespace {

struct Hint {
    Q_DECLARE_TR_FUNCTIONS(InspectHint)
};

} // namespace

InspectHint inspectHint(Workbench& workbench, const QString& time)
{
    ConnectSession& connection = workbench.connection();
    const InspectSession& session = workbench.inspection();
    switch (session.state()) {
    case InspectSession::State::Squeezing:
        return {Hint::tr("Squeezing…"), Hint::tr("Esc or STOP ends it at once")};
    case InspectSession::State::Judging:
        return {Hint::tr("Judging…"), {}};
    case InspectSession::State::Loading:
        return {Hint::tr("Reading the library…"), {}};
    case InspectSession::State::Ready:
        break;
    }
    if (connection.state() != ConnectSession::State::Connected)
        return {missingWords(connection).headline, missingWords(connection).detail};
    if (session.types().empty())
        return {Hint::tr("No types yet"), Hint::tr("Enroll at least one type (Ctrl+3), then inspect parts")};
    if (!connection.armed() && connection.identity().commandable)
        return {Hint::tr("Not armed"), Hint::tr("Place the part, hands clear, then arm the gripper")};
    return {Hint::tr("Ready"), Hint::tr("Place the part, then squeeze: %1").arg(time)};
}

InspectHint unknownCodeHint(const QString& code, const QString& expected)
{
    return {Hint::tr("No type is called or coded “%1”").arg(code),
            expected.isEmpty() ? Hint::tr("Nothing is expected, as before")
                               : Hint::tr("%1 is expected, as before").arg(expected)};
}

InspectHint expectedHint(const QString& expected)
{
    return {expected.isEmpty() ? Hint::tr("Nothing expected") : expected,
            expected.isEmpty() ? Hint::tr("The next part may be any enrolled type")
                               : Hint::tr("is expected from the next part on")};
}

InspectHint buttonHint()
{
    return {Hint::tr("Not ready to squeeze"),
            Hint::tr("The gripper's button squeezes once a gripper is connected and armed here")};
}

} // namespace gripscope
