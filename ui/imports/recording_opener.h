// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording/foreign_table.h"

#include <QByteArray>
#include <QObject>
#include <QString>

#include <functional>
#include <optional>

class QWidget;

namespace gripscope {

class Workbench;

/// Brings files to recordings: Gripscope's own at once; of a table of another program it asks first what in
/// it is what (ForeignTableDialog), with what was said of its layout before. Files are read in the pool.
class RecordingOpener : public QObject {
    Q_OBJECT
public:
    RecordingOpener(Workbench& workbench, QWidget* page);

    /// Of a table of another program: whether to ask although tables of its layout were asked about before.
    enum class Asking { Always, OnlyOfNew };
    /// `then` gets the recording; `otherwise` is called where there is none: it could not be read, which the
    /// message bar says, or the person did not want it after all.
    void open(const QString& file, std::function<void(Recording)> then, std::function<void()> otherwise,
              Asking asking = Asking::Always);

private:
    /// The beginning of a table of another program.
    struct Foreign {
        QString file;
        QByteArray head;
        ForeignTable table;
    };
    struct Opened {
        Expected<Recording> recording;
        std::optional<Foreign> foreign;
    };
    [[nodiscard]] static Opened read(const QString& file);
    void readAsBefore(const Foreign& foreign, const CsvReadOptions& before,
                      std::function<void(Recording)> then, std::function<void()> otherwise);
    void ask(const Foreign& foreign, std::function<void(Recording)> then, std::function<void()> otherwise);

    Workbench* m_workbench;
    QWidget* m_page;
};

} // namespace gripscope
