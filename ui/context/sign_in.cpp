// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/sign_in.h"

#include "core/library/audit/audit_trail.h"
#include "core/library/people/people_register.h"
#include "core/people/audit_entry.h"
#include "core/people/secret.h"
#include "ui/context/workbench.h"
#include "ui/settings/values/settings.h"

#include <QApplication>
#include <QCoreApplication>
#include <QEvent>
#include <QTimer>
#include <QWidget>

#include <algorithm>
#include <memory>

namespace gripscope {

using namespace Qt::StringLiterals;

SignIn::SignIn(Workbench& bench) : QObject(&bench), m_bench(&bench)
{
    m_sinceUse.start();
    QCoreApplication::instance()->installEventFilter(this);
    const auto use = [this] { m_sinceUse.restart(); };
    connect(&bench, &Workbench::inspectionChanged, this, use); // the button of the gripper counts, too
    connect(&bench, &Workbench::enrollmentChanged, this, use);
    connect(&bench, &Workbench::operatorChanged, this, [this] { apply(); });
    connect(&bench, &Workbench::libraryChanged, this, &SignIn::reload);
    Settings& settings = bench.settings();
    const auto readLimit = [this, &settings] {
        m_idleLimit = std::chrono::round<std::chrono::milliseconds>(
            std::chrono::duration<double, std::ratio<60>>(settings.get(setting::idleMinutes)));
    };
    readLimit();
    connect(&settings, &Settings::changed, this, readLimit);
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, &SignIn::checkIdle);
    timer->start(std::chrono::seconds(1));
    reload();
}

bool SignIn::may(Permission permission) const
{
    return !inForce() || (m_current && mayDo(m_current->role(), permission, m_known.arming));
}

void SignIn::apply(std::optional<Grant> grant)
{
    m_bench->library().actAs({m_bench->operatorName(), m_current, std::move(grant)});
}

void SignIn::reload()
{
    m_bench->background().ask<Known>(
        this,
        [](Library& library) -> Expected<Known> {
            ASSIGN_OR_RETURN(auto people, library.people().all());
            ASSIGN_OR_RETURN(const auto arming, library.people().arming());
            ASSIGN_OR_RETURN(const auto approval, library.people().approval());
            return Known{std::move(people), arming, approval};
        },
        [this](Expected<Known> known) {
            if (known) // a library that cannot be read is told by whoever needs it
                take(std::move(*known));
        });
}

void SignIn::take(Known known)
{
    m_read = true;
    if (known == m_known)
        return;
    const bool began = m_known.people.empty();
    m_known = std::move(known);
    if (m_current) {
        const auto self =
            std::find_if(m_known.people.begin(), m_known.people.end(),
                         [this](const Person& person) { return person.id == m_current->personId(); });
        // Another role than the one signed in with, or none any more: shown as it is from now on.
        if (self == m_known.people.end() || !self->active || self->role != m_current->role())
            signOut();
    } else if (began && inForce()) {
        m_bench->setOperatorName({}); // a name that anybody can type is nobody's signature any more
    }
    emit changed();
}

void SignIn::signIn(QObject* context, const QString& personId, Secret secret, Done done)
{
    const auto kept = std::make_shared<Secret>(std::move(secret));
    m_bench->background().ask<Authority>(
        context, [personId, kept](Library& library) { return library.people().signIn(personId, *kept); },
        [this, done = std::move(done)](const Expected<Authority>& who) {
            if (!who)
                return done(who.error().describe());
            if (m_current)
                signOut();
            m_current = *who;
            m_sinceUse.restart();
            m_bench->setOperatorName(who->name());
            apply();
            emit changed();
            done(std::nullopt);
        });
}

void SignIn::signOut(bool idle)
{
    if (!m_current)
        return;
    const Authority who = *std::exchange(m_current, std::nullopt);
    m_bench->setOperatorName({});
    apply();
    m_bench->background().ask<void>(
        this, [who, idle](Library& library) { return library.people().signedOut(who, idle); },
        [this](const Expected<void>& noted) {
            if (!noted)
                m_bench->messages().report(noted.error().describe());
        });
    if (idle)
        m_bench->messages().report(
            tr("%1 was signed out: nobody has done anything here for a while.").arg(who.name()));
    emit changed();
}

void SignIn::authorise(QObject* context, const QString& personId, Secret secret, Permission permission,
                       std::function<void(Expected<Grant>)> done)
{
    const auto kept = std::make_shared<Secret>(std::move(secret));
    m_bench->background().ask<Grant>(
        context,
        [personId, kept, permission](Library& library) {
            return library.people().authorise(personId, *kept, permission);
        },
        std::move(done));
}

void SignIn::withGrant(const Grant& grant, const std::function<void()>& action)
{
    apply(grant);
    action();
    apply();
}

bool SignIn::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::MouseButtonPress:
    case QEvent::TouchBegin:
    case QEvent::Wheel:
        m_sinceUse.restart();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void SignIn::checkIdle()
{
    if (m_current && m_idleLimit.count() > 0 && m_sinceUse.hasExpired(m_idleLimit.count()))
        signOut(true);
}

namespace {

/// The library's own check is the one that counts: what this window knows of the people may be old.
void tellArming(Workbench& bench, std::function<void(const Expected<void>&)> done)
{
    const GripperIdentity gripper = bench.connection().identity();
    bench.background().ask<void>(
        &bench,
        [serial = gripper.serial, address = gripper.address](Library& library) {
            return library.auditTrail().record(Permission::Arm,
                                               QString::fromUtf16(audit_action::gripperArmed), serial,
                                               {{u"from"_s, u"window"_s}, {u"address"_s, address}});
        },
        [&bench, done = std::move(done)](const Expected<void>& told) {
            if (!told)
                bench.messages().report(told.error().describe());
            done(told);
        });
}

/// What a question to the person who works here is shown over; none where no window is shown.
QWidget* windowInFront()
{
    if (QWidget* active = QApplication::activeWindow())
        return active;
    const QWidgetList windows = QApplication::topLevelWidgets();
    const auto shown = std::find_if(windows.begin(), windows.end(), [](const QWidget* one) {
        return one->isVisible() && one->windowType() == Qt::Window;
    });
    return shown == windows.end() ? nullptr : *shown;
}

} // namespace

void authorizeArming(Workbench& bench, std::function<void()> arm)
{
    const SignIn& signIn = bench.signIn();
    if (signIn.known() && !signIn.inForce()) {
        arm();
        return tellArming(bench, [&bench](const Expected<void>& told) {
            if (!told && told.error().code == ErrorCode::Usage) // people came into the library meanwhile
                bench.connection().disarm();
        });
    }
    const auto tellAndArm = [&bench, arm = std::move(arm)] {
        tellArming(bench, [arm](const Expected<void>& told) {
            if (told)
                arm();
        });
    };
    if (!signIn.known() || signIn.may(Permission::Arm))
        return tellAndArm();
    QWidget* parent = windowInFront();
    const QString needed = SignIn::tr("Sign in, then arm the gripper: the library keeps who armed it.");
    if (!parent || !signIn.current())
        bench.messages().report(needed);
    if (!parent)
        return;
    if (signIn.current())
        return emit bench.consentNeeded(parent, Permission::Arm, tellAndArm);
    emit bench.signInNeeded(parent);
}

} // namespace gripscope
