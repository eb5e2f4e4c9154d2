// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/process_session.h"

#include "core/session/process/fixed_limits.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

tl::unexpected<Error> nothingDrawn()
{
    return failure(ErrorCode::NotFound, {});
}

/// What average run lengths depend on.
QString runLengthKey(const ProcessOptions& options)
{
    return u"%1 %2 %3 %4 %5 %6 %7 %8"_s.arg(toString(options.kind), toString(options.rules))
        .arg(options.size())
        .arg(options.weight)
        .arg(options.width)
        .arg(options.reference)
        .arg(options.decision)
        .arg(options.falseAlarm);
}

} // namespace

std::array<Expected<QuantityChart>, 3> ProcessPicture::noCharts()
{
    return {nothingDrawn(), nothingDrawn(), nothingDrawn()};
}

std::array<Expected<ProcessCapability>, 3> ProcessPicture::noCapabilities()
{
    return {nothingDrawn(), nothingDrawn(), nothingDrawn()};
}

/// A picture on its way: parts that are worked out side by side.
struct ProcessSession::Drawing {
    ProcessPicture picture;
    std::array<Pending<Expected<QuantityChart>>, 3> charts;
    std::array<Pending<Expected<ProcessCapability>>, 3> capabilities;
    Pending<Expected<JointChart>> joint;
    Pending<RunLengths> runLengths;
    Pending<ProcessRows> rows;
    bool begun = false; ///< the rows are known

    [[nodiscard]] bool ready() const
    {
        const auto known = [](const auto& pending) { return !pending.waiting() || pending.ready(); };
        return begun && std::ranges::all_of(charts, known) && std::ranges::all_of(capabilities, known) &&
               known(joint) && known(runLengths);
    }
};

ProcessSession::ProcessSession(LibraryService& library) : m_library(&library), m_reader(library) {}

ProcessSession::~ProcessSession()
{
    m_pool.clear(); // what has not begun
}

void ProcessSession::setQuery(const ProcessQuery& query)
{
    if (query == m_query && m_state != State::Idle && m_state != State::Cancelled && m_state != State::Failed)
        return;
    m_query = query;
    m_values.reset();
    m_picture.reset();
    reload();
}

void ProcessSession::reload()
{
    read({});
}

void ProcessSession::refresh()
{
    if (m_query.type.isEmpty() || m_state == State::Idle || m_state == State::Cancelled)
        return;
    if (busy()) {
        m_behind = true;
        return;
    }
    read(m_values);
}

void ProcessSession::read(std::shared_ptr<const ProcessValues> known)
{
    m_error.reset();
    m_behind = false;
    m_drawing.reset();
    if (m_query.type.isEmpty()) {
        m_reader.cancel();
        m_state = State::Idle;
        return;
    }
    ProcessQuery query = m_query;
    if (known && !known->empty())
        query.after = known->newest;
    m_reader.start(query, std::move(known));
    m_state = State::Reading;
}

void ProcessSession::setFilter(const ProcessFilter& filter)
{
    if (filter == m_filter)
        return;
    m_filter = filter;
    draw();
}

void ProcessSession::setOptions(const ProcessOptions& options)
{
    m_options = options;
    m_options.fixed.reset();
    draw();
}

void ProcessSession::setUsesFixed(bool uses)
{
    if (m_usesFixed == uses)
        return;
    m_usesFixed = uses;
    draw();
}

void ProcessSession::cancel()
{
    if (!busy())
        return;
    m_reader.cancel();
    m_pool.clear();
    m_drawing.reset();
    m_behind = false;
    m_state = State::Cancelled;
}

void ProcessSession::fail(const Error& error)
{
    m_error = error;
    m_state = State::Failed;
}

Expected<void> ProcessSession::fix(qint64 first, qint64 last, const QString& operatorName)
{
    if (!m_picture)
        return nothingDrawn();
    ASSIGN_OR_RETURN(const FixedLimits fixed,
                     fixLimits(*m_picture->values, m_picture->rows, first, last, m_options));
    m_usesFixed = true;
    store(toText(fixed), operatorName);
    return {};
}

void ProcessSession::release(const QString& operatorName)
{
    store({}, operatorName);
}

void ProcessSession::store(const QString& limits, const QString& operatorName)
{
    using Stored = std::optional<ProcessLimitsRecord>;
    m_storing = PendingCall(m_library->run<Stored>([type = m_query.type, limits,
                                                    operatorName](Library& library) -> Expected<Stored> {
        RETURN_IF_ERROR(library.fixProcessLimits(type, limits, operatorName));
        return library.processLimits(type);
    }),
                            [this, type = m_query.type](Expected<Stored> stored) {
                                if (!stored)
                                    m_error = stored.error();
                                else if (type == m_query.type) {
                                    takeRecord(*stored);
                                    draw();
                                }
                            });
}

void ProcessSession::takeRecord(const std::optional<ProcessLimitsRecord>& record)
{
    m_record = record;
    m_fixed = fixedLimitsOf(record);
    if (!m_fixed)
        m_record.reset();
}

void ProcessSession::takeRead(ProcessReader::Found found)
{
    m_values = std::make_shared<const ProcessValues>(std::move(found.values));
    takeRecord(found.limits);
    m_state = State::Shown;
    draw();
}

void ProcessSession::draw()
{
    if (!m_values || m_state == State::Reading)
        return;
    m_pool.clear();
    m_drawing = std::make_shared<Drawing>();
    ProcessPicture& picture = m_drawing->picture;
    picture.values = m_values;
    picture.filter = m_filter;
    picture.options = m_options;
    if (m_usesFixed)
        picture.options.fixed = m_fixed;
    m_drawing->rows =
        inPool([values = m_values, filter = m_filter] { return processRows(*values, filter); }, m_pool);
    if (m_runLengths && m_runLengths->first == runLengthKey(m_options))
        picture.runLengths = m_runLengths->second;
    else
        m_drawing->runLengths = inPool([options = m_options] { return processRunLengths(options); }, m_pool);
    m_state = State::Drawing;
}

void ProcessSession::takeDrawn()
{
    Drawing& drawing = *m_drawing;
    if (std::optional<ProcessRows> rows = drawing.rows.take()) {
        drawing.picture.rows = std::move(*rows);
        drawing.begun = true;
        const auto shared = std::make_shared<const ProcessRows>(drawing.picture.rows);
        const auto values = m_values;
        const auto ranks = std::make_shared<SharedRanks>();
        const ProcessOptions& options = drawing.picture.options;
        // What takes longest first, so that all threads of the pool end together.
        for (std::size_t i = 0; i < 3; ++i)
            drawing.capabilities[i] =
                inPool([values, shared, i, options,
                        ranks] { return processCapability(*values, *shared, i, options, *ranks); },
                       m_pool);
        for (std::size_t i = 0; i < 3; ++i)
            if (options.kind != ProcessKind::Hotelling)
                drawing.charts[i] = inPool(
                    [values, shared, i, options] { return drawQuantity(*values, *shared, i, options); },
                    m_pool);
        if (options.kind == ProcessKind::Hotelling)
            drawing.joint =
                inPool([values, shared, options] { return drawJoint(*values, *shared, options); }, m_pool);
    }
    if (!drawing.ready())
        return;
    ProcessPicture& picture = drawing.picture;
    for (std::size_t i = 0; i < 3; ++i) {
        if (auto chart = drawing.charts[i].take())
            picture.charts[i] = std::move(*chart);
        if (auto capability = drawing.capabilities[i].take())
            picture.capabilities[i] = std::move(*capability);
    }
    if (auto joint = drawing.joint.take())
        picture.joint = std::move(*joint);
    if (const auto lengths = drawing.runLengths.take()) {
        picture.runLengths = *lengths;
        m_runLengths = {runLengthKey(picture.options), *lengths};
    }
    m_picture = std::make_shared<const ProcessPicture>(std::move(picture));
    m_drawing.reset();
    m_state = State::Shown;
}

bool ProcessSession::poll()
{
    const State before = m_state;
    bool changed = m_storing.poll();
    if (m_state == State::Reading) {
        if (auto found = m_reader.take()) {
            if (*found)
                takeRead(std::move(**found));
            else
                fail(found->error());
        }
        changed = true; // progress, at least
    }
    if (m_state == State::Drawing)
        takeDrawn();
    if (m_behind && m_state == State::Shown)
        read(m_values);
    return changed || m_state != before;
}

} // namespace gripscope
