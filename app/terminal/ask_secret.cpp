// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/ask_secret.h"

#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>
#endif

namespace gripscope {

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

#endif

} // namespace

#ifdef Q_OS_UNIX

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

} // namespace gripscope
