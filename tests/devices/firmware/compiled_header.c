/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/devices/firmware/compiled_header.h"

static const uint8_t descriptor[] = GRIPSCOPE_REPORT_DESCRIPTOR;

uint16_t compiled_crc16(const uint8_t* bytes, size_t size)
{
    return gripscope_crc16(0xFFFF, bytes, size);
}

uint16_t compiled_forces_crc(const int32_t* forces, size_t count)
{
    return gripscope_forces_crc(0xFFFF, forces, count);
}

size_t compiled_descriptor(uint8_t* bytes, size_t room)
{
    memcpy(bytes, descriptor, sizeof descriptor < room ? sizeof descriptor : room);
    return sizeof descriptor;
}

void compiled_stream(uint8_t* report, const gripscope_stream* stream)
{
    gripscope_write_stream(report, stream);
}

void compiled_acknowledgement(uint8_t* report, const gripscope_acknowledgement* answer)
{
    gripscope_write_acknowledgement(report, answer);
}

void compiled_identity(uint8_t* report, const gripscope_identity* identity)
{
    gripscope_write_identity(report, identity);
}

void compiled_measurement(uint8_t* report, const gripscope_measurement* measurement)
{
    gripscope_write_measurement(report, measurement);
}

void compiled_limits(uint8_t* report, const gripscope_limits* limits)
{
    gripscope_write_limits(report, limits);
}

gripscope_reading compiled_command(const uint8_t* report, size_t size, gripscope_command* command)
{
    return gripscope_read_command(report, size, command);
}

uint8_t compiled_answer_arm(uint32_t token, uint32_t* last_token, bool fault, bool armed)
{
    return gripscope_answer_arm(token, last_token, fault, armed);
}

bool compiled_feeds_watchdog(uint8_t id, uint8_t result)
{
    return gripscope_feeds_watchdog(id, result);
}

int64_t compiled_protective_force(int32_t limit, int32_t own_limit)
{
    return gripscope_protective_force(limit, own_limit);
}
