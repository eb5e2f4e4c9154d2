// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QString>
#include <QTemporaryDir>

#include <array>
#include <sys/inotify.h>
#include <unistd.h>

namespace gripscope::test {

/// A picture that nobody has a reason to open, and the kernel's word on whether somebody did.
class BaitFile {
public:
    BaitFile() : m_queue(inotify_init1(IN_NONBLOCK | IN_CLOEXEC))
    {
        QFile file(path());
        if (!file.open(QIODevice::WriteOnly) || file.write("P1 1 1 0\n") < 0)
            qFatal("there is no bait");
        file.close();
        if (inotify_add_watch(m_queue, path().toLocal8Bit().constData(), IN_OPEN) < 0)
            qFatal("the bait is not watched");
    }
    ~BaitFile() { ::close(m_queue); }
    BaitFile(const BaitFile&) = delete;
    BaitFile& operator=(const BaitFile&) = delete;

    [[nodiscard]] QString path() const { return m_folder.filePath(QStringLiteral("x.pbm")); }
    /// Since this was asked last.
    [[nodiscard]] bool wasOpened() const
    {
        alignas(inotify_event) std::array<char, 4096> events{};
        bool opened = false;
        while (::read(m_queue, events.data(), events.size()) > 0)
            opened = true;
        return opened;
    }

private:
    QTemporaryDir m_folder;
    int m_queue = -1;
};

} // namespace gripscope::test
