// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/authorize.h"

#include "core/store/audit_trail.h"
#include "ui/people/sign_in.h"
#include "ui/people/sign_in_dialog.h"
#include "ui/workbench.h"

namespace gripscope {

void authorize(Workbench& bench, QWidget* parent, Permission permission, std::function<void()> then)
{
    if (bench.signIn().may(permission)) {
        then();
        return;
    }
    auto* dialog = new SignInDialog(bench, permission, parent);
    QObject::connect(
        dialog, &SignInDialog::authorised, parent,
        [&bench, then = std::move(then)](const Grant& grant) { bench.signIn().withGrant(grant, then); });
    dialog->open();
}

void authorizeRecorded(Workbench& bench, QWidget* parent, Permission permission, const QString& action,
                       const QString& subject, const QJsonObject& details, std::function<void()> then)
{
    authorize(bench, parent, permission, [=, &bench, then = std::move(then)] {
        // While nobody can refuse it, it need not wait for the disk.
        const bool first = !bench.signIn().inForce();
        if (first)
            then();
        bench.ask<void>(
            parent,
            [=](Library& library) {
                return library.auditTrail().record(permission, action, subject, details);
            },
            [&bench, first, then](const Expected<void>& told) {
                if (!told)
                    bench.report(told.error().describe());
                else if (!first)
                    then();
            });
    });
}

} // namespace gripscope
