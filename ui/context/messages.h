// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

namespace gripscope {

/// What a person is told in the window's message bar: what went wrong, and what was done. A message may say
/// until when it is true: then it goes by itself, and nobody reads what is no longer so.
class Messages : public QObject {
    Q_OBJECT
public:
    using Condition = std::function<bool()>;

    /// `holds` is asked at every poll; what it uses must live as long as this.
    void report(const QString& message, Condition holds = {});
    /// Something was done as it was asked for: no warning.
    void tell(const QString& message) { emit told(message); }
    /// Takes back what no longer holds.
    void poll();

signals:
    void reported(const QString& message);
    void told(const QString& message);
    void withdrawn(const QString& message);

private:
    struct Standing {
        QString message;
        Condition holds;
    };
    std::vector<Standing> m_standing; ///< those with a condition
};

} // namespace gripscope
