// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/history_export.h"

#include "core/signal/recording_csv.h"

#include <QDir>
#include <QRegularExpression>
#include <QSaveFile>

#include <memory>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A file that is being written; without commit() nothing of it stays.
struct WholeFile {
    WholeFile(const HistoryQuery& query, HistoryFormat format, const QString& name)
        : document(query, format), file(name)
    {
    }
    HistoryDocument document;
    QSaveFile file;
};

} // namespace

SteppedWork::Step historyExport(const HistoryQuery& query, HistoryFormat format, const QString& file)
{
    auto writing = std::make_shared<WholeFile>(query, format, file);
    return [writing](Library& library) -> Expected<SteppedWork::Progress> {
        QSaveFile& out = writing->file;
        const auto failed = [&out] {
            return failure(ErrorCode::FileUnwritable, {out.fileName(), out.errorString()});
        };
        if (!out.isOpen() && !out.open(QIODevice::WriteOnly))
            return failed();
        const Expected<QByteArray> piece = writing->document.next(library);
        if (!piece)
            return tl::unexpected<Error>(piece.error());
        if (out.write(*piece) != piece->size() || (piece->isEmpty() && !out.commit()))
            return failed();
        return SteppedWork::Progress{writing->document.written(), writing->document.total(),
                                     !piece->isEmpty()};
    };
}

QString recordingFileName(const HistoryEntry& entry)
{
    if (entry.number > 0)
        return u"inspection_%1.csv"_s.arg(entry.number, 6, 10, QChar(u'0'));
    static const QRegularExpression awkward(u"[^\\w-]+"_s, QRegularExpression::UseUnicodePropertiesOption);
    QString type = entry.type;
    type.replace(awkward, u"_"_s);
    return u"enrolment_%1_%2.csv"_s.arg(type, entry.graspId.right(8));
}

SteppedWork::Step recordingExport(std::vector<QString> graspIds, const QString& folder)
{
    struct Writing {
        std::vector<QString> ids;
        std::size_t next = 0;
    };
    auto writing = std::make_shared<Writing>(Writing{std::move(graspIds), 0});
    return [writing, folder](Library& library) -> Expected<SteppedWork::Progress> {
        const SteppedWork::Progress nothing{0, 0, false};
        if (writing->next >= writing->ids.size())
            return nothing;
        const QString id = writing->ids[writing->next++];
        const auto entries = library.historyEntries({id});
        if (!entries)
            return tl::unexpected<Error>(entries.error());
        const auto recording = library.recording(id);
        if (!recording && recording.error().code != ErrorCode::NotFound)
            return tl::unexpected<Error>(recording.error());
        if (recording && !entries->empty())
            if (const auto done =
                    writeRecordingCsv(*recording, QDir(folder).filePath(recordingFileName(entries->front())));
                !done)
                return tl::unexpected<Error>(done.error());
        return SteppedWork::Progress{writing->next, writing->ids.size(), writing->next < writing->ids.size()};
    };
}

} // namespace gripscope
