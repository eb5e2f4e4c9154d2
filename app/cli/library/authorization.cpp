// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/authorization.h"

#include "core/library/people/people_register.h"
#include "core/people/secret.h"

#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>
#endif

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

tl::unexpected<Error> noTerminal()
{
    return failure(ErrorCode::Usage,
                   {u"A PIN or password is asked for on a terminal, and there is none here. Run "
                    "the command by hand."_s});
}

#ifdef Q_OS_UNIX

/// The terminal of this process with its echo off, until it goes.
class SilentTerminal {
public:
    SilentTerminal() : m_device(open("/dev/tty", O_RDWR | O_CLOEXEC))
    {
        if (m_device < 0 || tcgetattr(m_device, &m_before) != 0)
            return;
        termios silent = m_before;
        silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
        m_ready = tcsetattr(m_device, TCSAFLUSH, &silent) == 0;
    }
    ~SilentTerminal()
    {
        if (m_ready)
            tcsetattr(m_device, TCSAFLUSH, &m_before);
        if (m_device >= 0)
            close(m_device);
    }
    SilentTerminal(const SilentTerminal&) = delete;
    SilentTerminal& operator=(const SilentTerminal&) = delete;

    [[nodiscard]] bool isReady() const { return m_ready; }
    void write(const QString& text) const
    {
        const QByteArray bytes = text.toLocal8Bit();
        // A prompt that cannot be shown is no reason to fail: what is typed still counts.
        static_cast<void>(!::write(m_device, bytes.constData(), static_cast<std::size_t>(bytes.size())));
    }
    [[nodiscard]] QString readLine() const
    {
        QByteArray line;
        line.reserve(1024); // so that it is not copied about
        char letter = 0;
        while (line.size() < 1024 && read(m_device, &letter, 1) == 1 && letter != '\n')
            line.append(letter);
        QString text = QString::fromLocal8Bit(line);
        line.fill('\0');
        return text;
    }

private:
    int m_device;
    termios m_before{};
    bool m_ready = false;
};

/// Asks on the terminal itself, whatever standard input and output are, and shows nothing of what is typed.
/// Usage where there is no terminal: a secret on a command line or in a file is none.
Expected<Secret> askSecret(const QString& prompt)
{
    const SilentTerminal terminal;
    if (!terminal.isReady())
        return noTerminal();
    terminal.write(prompt);
    QString text = terminal.readLine();
    terminal.write(u"\n"_s);
    Secret secret(text);
    wipe(text);
    return secret;
}

#else

Expected<Secret> askSecret(const QString&)
{
    return noTerminal();
}

#endif

} // namespace

namespace {

Expected<Grant> consent(PeopleRegister people, Permission permission)
{
    const QString name = qEnvironmentVariable("GRIPSCOPE_PERSON").trimmed();
    if (name.isEmpty()) {
        ASSIGN_OR_RETURN(const auto arming, people.arming());
        const bool anyone = mayDo(Role::Operator, permission, arming);
        return failure(
            ErrorCode::Usage,
            {u"%1 needs %2 in this library. Set GRIPSCOPE_PERSON to the name; the PIN or password is then "
             "asked for."_s.arg(inWords(permission), anyone ? u"one of the people"_s : u"a supervisor"_s)});
    }
    ASSIGN_OR_RETURN(const auto person, people.named(name));
    ASSIGN_OR_RETURN(const auto secret,
                     askSecret(u"%1. PIN or password of %2: "_s.arg(inWords(permission), person.name)));
    return people.authorise(person.id, secret, permission);
}

} // namespace

Expected<Acting> authorization(Library& library, const QString& operatorName, Permission permission)
{
    const Acting anybody{operatorName};
    ASSIGN_OR_RETURN(const auto inForce, library.people().inForce());
    if (!inForce)
        return anybody;
    library.actAs(anybody); // wrong tries are told with that name
    ASSIGN_OR_RETURN(auto grant, consent(library.people(), permission));
    return Acting{operatorName, std::nullopt, std::move(grant)};
}

Expected<Acting> authorization(const QString& libraryFile, const QString& operatorName, Permission permission)
{
    if (!QFileInfo::exists(libraryFile))
        return Acting{operatorName};
    ASSIGN_OR_RETURN(const auto library, Library::open(libraryFile));
    return authorization(*library, operatorName, permission);
}

} // namespace gripscope::cli
