// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <memory>

namespace gripscope {

/// Hears from the desktop when the person leaves the station. What a platform does not tell is not heard;
/// each has a file of its own (station_watch_linux.cpp).
class StationWatch : public QObject {
    Q_OBJECT
public:
    enum class Departure { Locked, Suspended, Switched };
    using QObject::QObject;

signals:
    void left(gripscope::StationWatch::Departure how);
};

/// Listens from now on; asking the system takes place behind.
[[nodiscard]] std::unique_ptr<StationWatch> makeStationWatch();

} // namespace gripscope
