// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/spill/inspection_spill.h"

#include "core/base/words.h"
#include "core/library/spill/spill_file.h"
#include "core/library/spill/spilled_inspection.h"
#include "core/library/sql/time_ordered_id.h"

#include <QDir>
#include <QFileInfo>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A squeeze of ten seconds at 16 kHz takes less.
constexpr qint64 roomOfOne = 1'000'000;

Error keptAside(const Finding& reason, const QString& where)
{
    return {ErrorCode::Usage,
            {Words::say("Inspections that waited to be stored cannot be read (%1). Their file is kept as %2.")
                 .arg(reason, where)}};
}

/// What of a file belongs to this library. A file with anything else is kept under another name.
struct FoundInFile {
    SpillFile::Contents contents;
    std::vector<NewInspection> inspections;
    bool setAside = false;
};

Expected<FoundInFile> findIn(SpillFile& file, const QByteArray& owner, std::optional<Error>& lost)
{
    FoundInFile found;
    ASSIGN_OR_RETURN(found.contents, file.read());
    bool damaged = found.contents.damaged;
    if (!damaged && !found.contents.waiting.empty() && !isSpillOwner(found.contents.owner, owner)) {
        ASSIGN_OR_RETURN(const QString kept, file.setAside());
        lost = keptAside(Words::say("the library is another than the one they were made for"), kept);
        return FoundInFile{{}, {}, true};
    }
    if (isSpillOwner(found.contents.owner, owner))
        for (SpilledInspection& one : unpackedOf(found.contents, damaged))
            found.inspections.push_back(std::move(one.inspection));
    if (!damaged)
        return found;
    ASSIGN_OR_RETURN(const QString kept, file.setAside());
    lost = keptAside(Words::say("bytes of their file are damaged"), kept);
    found.setAside = true;
    return found;
}

/// Puts what another file held into the own one. False where not all of it went in; storing it twice does no
/// harm.
bool adopt(SpillFile& own, const std::vector<NewInspection>& inspections,
           std::vector<SpilledInspection>& waiting)
{
    for (const NewInspection& inspection : inspections) {
        const Expected<qint64> place =
            packInspection(inspection).and_then([&own](const QByteArray& bytes) { return own.add(bytes); });
        if (!place)
            return false;
        waiting.push_back({inspection, *place});
    }
    return true;
}

/// Not lost: the next one that opens has room for them.
Error stillWaiting(const QString& where)
{
    return {
        ErrorCode::Usage,
        {Words::say("Some of the inspections that another program left in %1 wait there until this program "
                    "is started again: there is no room for more.")
             .arg(where)}};
}

} // namespace

struct InspectionSpill::Private {
    mutable std::mutex mutex; ///< guards jobs and ending
    std::condition_variable wake;
    std::deque<std::function<void()>> jobs;
    bool ending = false;

    std::mutex fileMutex; ///< guards file; held while the disk works, so never asked for by a screen
    std::unique_ptr<SpillFile> file;
    std::atomic<bool> isOpen = false;
    std::atomic<qint64> room = 0;
    std::thread thread;

    void loop()
    {
        while (true) {
            std::function<void()> job;
            {
                std::unique_lock lock(mutex);
                wake.wait(lock, [this] { return ending || !jobs.empty(); });
                if (jobs.empty())
                    return;
                job = std::move(jobs.front());
                jobs.pop_front();
            }
            job();
        }
    }

    Expected<qint64> add(const NewInspection& inspection)
    {
        ASSIGN_OR_RETURN(const QByteArray bytes, packInspection(inspection));
        const std::lock_guard lock(fileMutex);
        if (!file)
            return failure(ErrorCode::FileUnwritable, {Words::say("The file for what is not stored yet"),
                                                       Words::say("it is not there")});
        Expected<qint64> place = file->add(bytes);
        room = file->room();
        return place;
    }
};

QString InspectionSpill::file(const QString& libraryFile, int program)
{
    const QFileInfo witness(witnessFile(libraryFile));
    return witness.path() + u"/%1-%2.spill"_s.arg(witness.completeBaseName(), QString::number(program));
}

InspectionSpill::InspectionSpill() : d(std::make_unique<Private>())
{
    d->thread = std::thread([p = d.get()] { p->loop(); });
}

InspectionSpill::~InspectionSpill()
{
    {
        const std::lock_guard lock(d->mutex);
        d->ending = true;
    }
    d->wake.notify_one();
    d->thread.join();
}

Expected<InspectionSpill::Opened> InspectionSpill::open(const QString& libraryFile,
                                                        const std::optional<ChainEnd>& birth)
{
    const std::lock_guard lock(d->fileMutex);
    const QByteArray owner = spillOwner(birth);
    QDir().mkpath(QFileInfo(file(libraryFile, 1)).path());
    Opened opened;
    std::unique_ptr<SpillFile> own;
    for (int program = 1; program <= mostPrograms; ++program) {
        const QString name = file(libraryFile, program);
        const auto missing = own ? SpillFile::Missing::Leave : SpillFile::Missing::Make;
        ASSIGN_OR_RETURN(std::unique_ptr<SpillFile> here, SpillFile::open(name, missing));
        if (!here)
            continue;
        ASSIGN_OR_RETURN(FoundInFile found, findIn(*here, owner, opened.lost));
        if (own) {
            const bool adopted = adopt(*own, found.inspections, opened.waiting);
            if (adopted && !found.setAside)
                here->discard();
            else if (!adopted && !opened.lost)
                opened.lost = stillWaiting(name);
        } else if (found.setAside) {
            ASSIGN_OR_RETURN(own, SpillFile::open(name, SpillFile::Missing::Make));
            if (!own)
                continue;
            RETURN_IF_ERROR(own->prepare(owner, {}));
            static_cast<void>(adopt(*own, found.inspections, opened.waiting));
        } else {
            own = std::move(here);
            RETURN_IF_ERROR(own->prepare(owner, found.contents));
            for (std::size_t i = 0; i < found.inspections.size(); ++i)
                opened.waiting.push_back({std::move(found.inspections[i]), found.contents.waiting[i].place});
        }
    }
    if (!own)
        return failure(ErrorCode::FileUnwritable,
                       {file(libraryFile, mostPrograms), Words::say("other programs have it")});
    d->file = std::move(own);
    d->room = d->file->room();
    d->isOpen = true;
    return opened;
}

Pending<Expected<qint64>> InspectionSpill::add(const NewInspection& inspection)
{
    const Promise<Expected<qint64>> answer;
    {
        const std::lock_guard lock(d->mutex);
        d->jobs.emplace_back([p = d.get(), answer, inspection] { answer.give(p->add(inspection)); });
    }
    d->wake.notify_one();
    return answer.pending();
}

void InspectionSpill::remove(qint64 place)
{
    const std::lock_guard lock(d->fileMutex);
    if (!d->file)
        return;
    // One that stays is stored again by its key, which is once.
    static_cast<void>(d->file->remove(place));
    d->room = d->file->room();
}

Expected<QString> InspectionSpill::keepAside(const QString& libraryFile, const std::optional<ChainEnd>& birth,
                                             const NewInspection& inspection)
{
    const QString name = file(libraryFile, 1) + u".kept-"_s + newTimeOrderedId();
    ASSIGN_OR_RETURN(const QByteArray bytes, packInspection(inspection));
    ASSIGN_OR_RETURN(const auto kept, SpillFile::open(name, SpillFile::Missing::Make));
    if (!kept)
        return failure(ErrorCode::FileUnwritable, {name, Words::say("another program has it")});
    RETURN_IF_ERROR(kept->prepare(spillOwner(birth), {}));
    RETURN_IF_ERROR(kept->add(bytes));
    return name;
}

bool InspectionSpill::isOpen() const
{
    return d->isOpen;
}

bool InspectionSpill::hasRoom() const
{
    return d->isOpen && d->room >= roomOfOne;
}

} // namespace gripscope
