// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/sign_in.h"

#include "core/people/secret.h"
#include "core/store/people_register.h"
#include "ui/settings/settings.h"
#include "ui/workbench.h"

#include <QCoreApplication>
#include <QEvent>
#include <QTimer>

#include <algorithm>
#include <memory>

namespace gripscope {

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
    return !inForce() || (m_current && mayDo(m_current->role(), permission));
}

void SignIn::apply(std::optional<Grant> grant)
{
    m_bench->library().actAs({m_bench->operatorName(), m_current, std::move(grant)});
}

void SignIn::reload()
{
    using People = std::vector<Person>;
    m_bench->ask<People>(
        this, [](Library& library) { return library.people().all(); },
        [this](Expected<People> people) {
            if (people) // a library that cannot be read is told by whoever needs it
                setPeople(std::move(*people));
        });
}

void SignIn::setPeople(std::vector<Person> people)
{
    if (people == m_people)
        return;
    const bool began = m_people.empty();
    m_people = std::move(people);
    if (m_current) {
        const auto self = std::find_if(m_people.begin(), m_people.end(), [this](const Person& person) {
            return person.id == m_current->personId();
        });
        // Another role than the one signed in with, or none any more: shown as it is from now on.
        if (self == m_people.end() || !self->active || self->role != m_current->role())
            signOut();
    } else if (began && inForce()) {
        m_bench->setOperatorName({}); // a name that anybody can type is nobody's signature any more
    }
    emit changed();
}

void SignIn::signIn(QObject* context, const QString& personId, Secret secret, Done done)
{
    const auto kept = std::make_shared<Secret>(std::move(secret));
    m_bench->ask<Authority>(
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
    m_bench->ask<void>(
        this, [who, idle](Library& library) { return library.people().signedOut(who, idle); },
        [this](const Expected<void>& noted) {
            if (!noted)
                m_bench->report(noted.error().describe());
        });
    if (idle)
        m_bench->report(tr("%1 was signed out: nobody has done anything here for a while.").arg(who.name()));
    emit changed();
}

void SignIn::authorise(QObject* context, const QString& personId, Secret secret, Permission permission,
                       std::function<void(Expected<Grant>)> done)
{
    const auto kept = std::make_shared<Secret>(std::move(secret));
    m_bench->ask<Grant>(
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

} // namespace gripscope
