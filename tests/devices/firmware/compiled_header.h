/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef COMPILED_HEADER_H
#define COMPILED_HEADER_H

/* The firmware header's functions as a C11 compiler made them, for a test in C++ to call. */

#include "devices/firmware/gripscope_protocol.h"

#ifdef __cplusplus
extern "C" {
#endif

uint16_t compiled_crc16(const uint8_t* bytes, size_t size);
uint16_t compiled_forces_crc(const int32_t* forces, size_t count);
size_t compiled_descriptor(uint8_t* bytes, size_t room);
void compiled_stream(uint8_t* report, const gripscope_stream* stream);
void compiled_acknowledgement(uint8_t* report, const gripscope_acknowledgement* answer);
void compiled_identity(uint8_t* report, const gripscope_identity* identity);
void compiled_measurement(uint8_t* report, const gripscope_measurement* measurement);
void compiled_limits(uint8_t* report, const gripscope_limits* limits);
gripscope_reading compiled_command(const uint8_t* report, size_t size, gripscope_command* command);
uint8_t compiled_answer_arm(uint32_t token, uint32_t* last_token, bool fault, bool armed);
bool compiled_feeds_watchdog(uint8_t id, uint8_t result);
int64_t compiled_protective_force(int32_t limit, int32_t own_limit);

#ifdef __cplusplus
}
#endif

#endif
