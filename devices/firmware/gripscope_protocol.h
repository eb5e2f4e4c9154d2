/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRIPSCOPE_PROTOCOL_H
#define GRIPSCOPE_PROTOCOL_H

/*
 * The device's side of the Gripscope protocol 1.1 (devices/PROTOCOL.md) for firmware, in C11: what a gripper
 * sends into 64 bytes, what it is told out of them. Freestanding but for memcpy and memset; no memory of its
 * own, no allocation, any byte order of the processor. A double is 8 bytes of IEEE 754.
 *
 *     on each output report:  gripscope_read_command(), act, gripscope_write_acknowledgement()
 *     each millisecond:       gripscope_write_stream()
 *     on GET_REPORT:          gripscope_write_identity() / _measurement() / _limits()
 *
 * What the device must do by itself (limits, watchdog, states) is section 6 of that document.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    GRIPSCOPE_REPORT_SIZE = 64,
    GRIPSCOPE_PROTOCOL_VERSION = 0x11, /* 1.1 */
    GRIPSCOPE_SAMPLES_PER_REPORT = 5,
    GRIPSCOPE_FORCES_PER_UPLOAD = 12
};

/* Report IDs. */
enum {
    GRIPSCOPE_STREAM = 0x01,
    GRIPSCOPE_ACKNOWLEDGEMENT = 0x02,
    GRIPSCOPE_IDENTITY = 0x10,
    GRIPSCOPE_MEASUREMENT = 0x11,
    GRIPSCOPE_LIMITS = 0x12,
    GRIPSCOPE_ARM = 0x20,
    GRIPSCOPE_DISARM = 0x21,
    GRIPSCOPE_STOP = 0x22,
    GRIPSCOPE_HEARTBEAT = 0x23,
    GRIPSCOPE_SET_LIMITS = 0x24,
    GRIPSCOPE_UPLOAD = 0x25,
    GRIPSCOPE_START = 0x26,
    GRIPSCOPE_FINISH = 0x27
};

/* Status bits. */
enum {
    GRIPSCOPE_ARMED = 0x0001,
    GRIPSCOPE_MOVING = 0x0002,
    GRIPSCOPE_FORCE_LIMIT = 0x0004,
    GRIPSCOPE_TRAVEL_LIMIT = 0x0008,
    GRIPSCOPE_FORCE_SATURATED = 0x0010,
    GRIPSCOPE_POSITION_SATURATED = 0x0020,
    GRIPSCOPE_FAULT_PRESENT = 0x0040,
    GRIPSCOPE_WATCHDOG = 0x0080,
    GRIPSCOPE_BUTTON = 0x0100 /* held, debounced; at least 20 ms */
};

/* Results of commands. */
enum {
    GRIPSCOPE_DONE = 0,
    GRIPSCOPE_REPEATED = 1,
    GRIPSCOPE_NOT_ARMED = 2,
    GRIPSCOPE_BUSY = 3,
    GRIPSCOPE_LIMIT_EXCEEDED = 4,
    GRIPSCOPE_BAD_VALUE = 5,
    GRIPSCOPE_INCOMPLETE = 6,
    GRIPSCOPE_CHECKSUM_DIFFERS = 7,
    GRIPSCOPE_SPENT = 8,
    GRIPSCOPE_UNKNOWN_COMMAND = 9,
    GRIPSCOPE_FAULT = 10
};

/* Which number of Set limits was refused: the detail of its answer. */
enum { GRIPSCOPE_DETAIL_FORCE = 1, GRIPSCOPE_DETAIL_TRAVEL = 2 };

/* What a gripper must keep to; sections 1 and 6 of the document. A Measurement feature outside these ranges
 * cannot be read or, where it says so, only be listened to. */
enum {
    GRIPSCOPE_WATCHDOG_MIN_MS = 100, /* outside: only listened to */
    GRIPSCOPE_WATCHDOG_MAX_MS = 200,
    GRIPSCOPE_LONGEST_REPORT_PERIOD_MS = 20, /* longer: only listened to */
    GRIPSCOPE_SHORTEST_REST_MS = 20,         /* before and after an excitation */
    GRIPSCOPE_BUTTON_AND_FAULT_MS = 20,      /* shown at least so long */
    GRIPSCOPE_SAMPLES_ABOVE_LIMIT = 3        /* in a row, until a measured force or travel stops it */
};
#define GRIPSCOPE_PER_COUNT_MIN 1e-12
#define GRIPSCOPE_PER_COUNT_MAX 1e6
#define GRIPSCOPE_SAMPLE_TIME_MIN_S 1e-6
#define GRIPSCOPE_SAMPLE_TIME_MAX_S 1.0 /* above 0.02: only listened to */
#define GRIPSCOPE_LAG_MAX_S 0.1         /* either way */

/* Excitation states. */
enum {
    GRIPSCOPE_NO_EXCITATION = 0,
    GRIPSCOPE_LOADING = 1,
    GRIPSCOPE_RUNNING = 2,
    GRIPSCOPE_FINISHED = 3,
    GRIPSCOPE_STOPPED = 4
};

/* The report descriptor, byte for byte. */
#define GRIPSCOPE_REPORT_DESCRIPTOR                                                                          \
    {                                                                                                        \
        0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x15, 0x00, 0x26, 0xff, 0x00, 0x75, 0x08, 0x95, 0x3f,      \
            0x85, 0x01, 0x09, 0x01, 0x81, 0x02, 0x85, 0x02, 0x09, 0x01, 0x81, 0x02, 0x85, 0x20, 0x09, 0x01,  \
            0x91, 0x02, 0x85, 0x21, 0x09, 0x01, 0x91, 0x02, 0x85, 0x22, 0x09, 0x01, 0x91, 0x02, 0x85, 0x23,  \
            0x09, 0x01, 0x91, 0x02, 0x85, 0x24, 0x09, 0x01, 0x91, 0x02, 0x85, 0x25, 0x09, 0x01, 0x91, 0x02,  \
            0x85, 0x26, 0x09, 0x01, 0x91, 0x02, 0x85, 0x27, 0x09, 0x01, 0x91, 0x02, 0x85, 0x10, 0x09, 0x01,  \
            0xb1, 0x02, 0x85, 0x11, 0x09, 0x01, 0xb1, 0x02, 0x85, 0x12, 0x09, 0x01, 0xb1, 0x02, 0xc0         \
    }

/* Force and position in counts. */
typedef struct {
    int32_t force, position;
} gripscope_sample;

/* All samples of a report share its status and follow each other without a gap. */
typedef struct {
    uint16_t status;
    uint32_t report_sequence; /* one more with each stream report */
    uint32_t first_sample;    /* sequence of the first sample */
    uint32_t time_us;         /* of the first sample */
    uint8_t excitation_state;
    uint16_t excitation; /* number that the state belongs to */
    uint8_t sample_count;
    gripscope_sample samples[GRIPSCOPE_SAMPLES_PER_REPORT];
} gripscope_stream;

typedef struct {
    uint16_t status; /* after the command */
    uint16_t number;
    uint8_t command; /* report ID of what is answered */
    uint8_t result;
    uint32_t detail;
    uint32_t time_us; /* of the next sample to be taken */
    uint8_t excitation_state;
    uint16_t excitation;
} gripscope_acknowledgement;

/* UTF-8; what is longer than 24, 10 and 24 bytes is cut, so keep it shorter. */
typedef struct {
    const char *serial, *firmware, *name;
} gripscope_identity;

typedef struct {
    uint8_t force_unit;    /* 0 not known, 1 N, 2 mN, 3 kN */
    uint8_t position_unit; /* 0 not known, 1 m, 2 mm, 3 um */
    bool straight_force;   /* between two samples; else it is held */
    bool commandable;
    uint16_t watchdog_ms;
    double force_per_count, position_per_count, sample_time_s;
    double force_lag_s; /* how much later position samples than force */
} gripscope_measurement;

typedef struct {
    int32_t force, travel; /* counts */
    uint32_t samples;
} gripscope_limits;

/* What a command carries; fields that do not belong to its ID are zero. */
typedef struct {
    uint8_t id; /* GRIPSCOPE_ARM to GRIPSCOPE_FINISH, or one that is not known */
    uint16_t number;
    uint32_t bad_detail;           /* what to answer as the detail of GRIPSCOPE_ANSWER_BAD */
    uint32_t token;                /* arm; 0: the program has none */
    int32_t max_force, max_travel; /* set limits */
    uint16_t excitation;           /* upload, start, finish */
    uint32_t first;                /* upload: index of the first force */
    uint8_t force_count;           /* upload */
    int32_t forces[GRIPSCOPE_FORCES_PER_UPLOAD];
    uint32_t samples;    /* start */
    uint16_t forces_crc; /* start */
} gripscope_command;

/* What to do with a report that came. */
typedef enum {
    GRIPSCOPE_DROP,           /* length, CRC or major version: count it, answer nothing */
    GRIPSCOPE_OBEY,           /* a command whose form is right: do it and answer */
    GRIPSCOPE_ANSWER_UNKNOWN, /* answer GRIPSCOPE_UNKNOWN_COMMAND */
    GRIPSCOPE_ANSWER_BAD      /* answer GRIPSCOPE_BAD_VALUE, with bad_detail */
} gripscope_reading;

/* CRC-16/CCITT-FALSE; begin with 0xFFFF and go on with what came out. */
static inline uint16_t gripscope_crc16(uint16_t crc, const uint8_t* bytes, size_t size)
{
    for (size_t i = 0; i < size; ++i) {
        crc = (uint16_t)(crc ^ (uint16_t)((uint16_t)bytes[i] << 8));
        for (int bit = 0; bit < 8; ++bit)
            crc = (uint16_t)((crc & 0x8000u) != 0 ? (uint16_t)(crc << 1) ^ 0x1021u : (uint16_t)(crc << 1));
    }
    return crc;
}

static inline void gripscope_store16(uint8_t* at, uint16_t value)
{
    at[0] = (uint8_t)value;
    at[1] = (uint8_t)(value >> 8);
}

static inline void gripscope_store32(uint8_t* at, uint32_t value)
{
    gripscope_store16(at, (uint16_t)value);
    gripscope_store16(at + 2, (uint16_t)(value >> 16));
}

static inline void gripscope_store_double(uint8_t* at, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    gripscope_store32(at, (uint32_t)bits);
    gripscope_store32(at + 4, (uint32_t)(bits >> 32));
}

static inline void gripscope_store_text(uint8_t* at, size_t size, const char* text)
{
    for (size_t i = 0; i < size && text[i] != '\0'; ++i)
        at[i] = (uint8_t)text[i];
}

static inline uint16_t gripscope_load16(const uint8_t* at)
{
    return (uint16_t)(at[0] | (uint16_t)((uint16_t)at[1] << 8));
}

static inline uint32_t gripscope_load32(const uint8_t* at)
{
    return gripscope_load16(at) | (uint32_t)gripscope_load16(at + 2) << 16;
}

/* Signed numbers without relying on how a processor converts what does not fit. */
static inline int32_t gripscope_load_signed(const uint8_t* at)
{
    const uint32_t bits = gripscope_load32(at);
    int32_t value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* CRC over forces as Start carries it: begin with 0xFFFF and add them in order. */
static inline uint16_t gripscope_forces_crc(uint16_t crc, const int32_t* forces, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        uint8_t bytes[4];
        gripscope_store32(bytes, (uint32_t)forces[i]);
        crc = gripscope_crc16(crc, bytes, sizeof bytes);
    }
    return crc;
}

static inline void gripscope_begin(uint8_t report[GRIPSCOPE_REPORT_SIZE], uint8_t id)
{
    memset(report, 0, GRIPSCOPE_REPORT_SIZE);
    report[0] = id;
    report[1] = GRIPSCOPE_PROTOCOL_VERSION;
}

static inline void gripscope_seal(uint8_t report[GRIPSCOPE_REPORT_SIZE])
{
    gripscope_store16(report + 62, gripscope_crc16(0xFFFF, report, 62));
}

static inline void gripscope_write_stream(uint8_t report[GRIPSCOPE_REPORT_SIZE],
                                          const gripscope_stream* stream)
{
    gripscope_begin(report, GRIPSCOPE_STREAM);
    gripscope_store16(report + 2, stream->status);
    gripscope_store32(report + 4, stream->report_sequence);
    gripscope_store32(report + 8, stream->first_sample);
    gripscope_store32(report + 12, stream->time_us);
    report[16] = stream->excitation_state;
    report[17] = stream->sample_count;
    gripscope_store16(report + 18, stream->excitation);
    for (size_t i = 0; i < stream->sample_count && i < GRIPSCOPE_SAMPLES_PER_REPORT; ++i) {
        gripscope_store32(report + 20 + 8 * i, (uint32_t)stream->samples[i].force);
        gripscope_store32(report + 24 + 8 * i, (uint32_t)stream->samples[i].position);
    }
    gripscope_seal(report);
}

static inline void gripscope_write_acknowledgement(uint8_t report[GRIPSCOPE_REPORT_SIZE],
                                                   const gripscope_acknowledgement* answer)
{
    gripscope_begin(report, GRIPSCOPE_ACKNOWLEDGEMENT);
    gripscope_store16(report + 2, answer->status);
    gripscope_store16(report + 4, answer->number);
    report[6] = answer->command;
    report[7] = answer->result;
    gripscope_store32(report + 8, answer->detail);
    gripscope_store32(report + 12, answer->time_us);
    report[16] = answer->excitation_state;
    gripscope_store16(report + 18, answer->excitation);
    gripscope_seal(report);
}

static inline void gripscope_write_identity(uint8_t report[GRIPSCOPE_REPORT_SIZE],
                                            const gripscope_identity* identity)
{
    gripscope_begin(report, GRIPSCOPE_IDENTITY);
    gripscope_store_text(report + 4, 24, identity->serial);
    gripscope_store_text(report + 28, 10, identity->firmware);
    gripscope_store_text(report + 38, 24, identity->name);
    gripscope_seal(report);
}

static inline void gripscope_write_measurement(uint8_t report[GRIPSCOPE_REPORT_SIZE],
                                               const gripscope_measurement* measurement)
{
    gripscope_begin(report, GRIPSCOPE_MEASUREMENT);
    report[2] = measurement->force_unit;
    report[3] = measurement->position_unit;
    report[4] = measurement->straight_force ? 1 : 0;
    report[5] = measurement->commandable ? 1 : 0;
    gripscope_store16(report + 6, measurement->watchdog_ms);
    gripscope_store_double(report + 8, measurement->force_per_count);
    gripscope_store_double(report + 16, measurement->position_per_count);
    gripscope_store_double(report + 24, measurement->sample_time_s);
    gripscope_store_double(report + 32, measurement->force_lag_s);
    gripscope_seal(report);
}

static inline void gripscope_write_limits(uint8_t report[GRIPSCOPE_REPORT_SIZE],
                                          const gripscope_limits* limits)
{
    gripscope_begin(report, GRIPSCOPE_LIMITS);
    gripscope_store32(report + 4, (uint32_t)limits->force);
    gripscope_store32(report + 8, (uint32_t)limits->travel);
    gripscope_store32(report + 12, limits->samples);
    gripscope_seal(report);
}

/* The fields of a known command; false where one is outside its range. */
static inline bool gripscope_read_fields(const uint8_t* report, gripscope_command* command)
{
    switch (command->id) {
    case GRIPSCOPE_ARM:
        command->token = gripscope_load32(report + 8);
        return memcmp(report + 4, "ARM!", 4) == 0;
    case GRIPSCOPE_SET_LIMITS:
        command->max_force = gripscope_load_signed(report + 4);
        command->max_travel = gripscope_load_signed(report + 8);
        if (command->max_force <= 0)
            command->bad_detail = GRIPSCOPE_DETAIL_FORCE;
        else if (command->max_travel <= 0)
            command->bad_detail = GRIPSCOPE_DETAIL_TRAVEL;
        return command->bad_detail == 0;
    case GRIPSCOPE_UPLOAD:
        command->excitation = gripscope_load16(report + 4);
        command->force_count = report[6];
        command->first = gripscope_load32(report + 8);
        if (command->force_count < 1 || command->force_count > GRIPSCOPE_FORCES_PER_UPLOAD)
            return false;
        for (size_t i = 0; i < command->force_count; ++i)
            command->forces[i] = gripscope_load_signed(report + 12 + 4 * i);
        return true;
    case GRIPSCOPE_START:
        command->excitation = gripscope_load16(report + 4);
        command->forces_crc = gripscope_load16(report + 6);
        command->samples = gripscope_load32(report + 8);
        return true;
    case GRIPSCOPE_FINISH:
        command->excitation = gripscope_load16(report + 4);
        return true;
    default:
        return true; /* disarm, stop, heartbeat: nothing but a number */
    }
}

/* Whatever comes out, the command's ID and number are those to answer with; after GRIPSCOPE_DROP they are
 * zero. */
static inline gripscope_reading gripscope_read_command(const uint8_t* report, size_t size,
                                                       gripscope_command* command)
{
    memset(command, 0, sizeof *command);
    if (size != GRIPSCOPE_REPORT_SIZE ||
        gripscope_load16(report + 62) != gripscope_crc16(0xFFFF, report, 62) ||
        report[1] >> 4 != GRIPSCOPE_PROTOCOL_VERSION >> 4)
        return GRIPSCOPE_DROP;
    command->id = report[0];
    command->number = gripscope_load16(report + 2);
    if (command->id < GRIPSCOPE_ARM || command->id > GRIPSCOPE_FINISH)
        return GRIPSCOPE_ANSWER_UNKNOWN;
    return gripscope_read_fields(report, command) ? GRIPSCOPE_OBEY : GRIPSCOPE_ANSWER_BAD;
}

/* What to answer to an Arm whose form is right; GRIPSCOPE_DONE: arm now, and clear the limit and watchdog
 * bits. *last_token is 0 at power-up and the device's to keep. The same token never arms twice, so that a
 * repeat whose first answer was lost cannot arm a gripper that has stopped since. */
static inline uint8_t gripscope_answer_arm(uint32_t token, uint32_t* last_token, bool fault, bool armed)
{
    if (token != 0 && token == *last_token)
        return GRIPSCOPE_REPEATED;
    if (fault)
        return GRIPSCOPE_FAULT;
    if (token != 0)
        *last_token = token;
    return armed ? GRIPSCOPE_REPEATED : GRIPSCOPE_DONE;
}

/* Whether a command with that answer starts the watchdog's time anew. */
static inline bool gripscope_feeds_watchdog(uint8_t id, uint8_t result)
{
    switch (id) {
    case GRIPSCOPE_ARM:
        return result == GRIPSCOPE_DONE;
    case GRIPSCOPE_HEARTBEAT:
    case GRIPSCOPE_SET_LIMITS:
    case GRIPSCOPE_UPLOAD:
    case GRIPSCOPE_START:
    case GRIPSCOPE_FINISH:
        return result == GRIPSCOPE_DONE || result == GRIPSCOPE_REPEATED;
    default:
        return false; /* disarm, stop and whatever is not known */
    }
}

/* The measured force, in counts, beyond which GRIPSCOPE_SAMPLES_ABOVE_LIMIT samples in a row stop an armed
 * gripper: 5 % of the limit in force and 1 % of the largest force of the Limits feature above the limit, so
 * that no noise does. What is commanded is compared with the limit itself. */
static inline int64_t gripscope_protective_force(int32_t limit, int32_t own_limit)
{
    return (int64_t)limit + limit / 20 + own_limit / 100;
}

#ifdef __cplusplus
}
#endif

#endif
