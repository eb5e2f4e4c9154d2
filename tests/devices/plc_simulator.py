#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A PLC as an independent client (python3-pymodbus) that behaves badly: it delays, loses, doubles and belates its
writes, reconnects in the middle of them and forgets to acknowledge. It holds every result against its part.

  plc_simulator.py PORT CYCLES SEED

The station at PORT answers m = token mod 100003, k = sequence mod 65521, evaluation = token mod 3 + 1. The last line
is JSON with what was counted; the exit code is 1 where a part was mixed or lost, or an overrun not told."""
import json
import random
import struct
import sys
import time

from pymodbus.client import ModbusTcpClient

PORT, CYCLES, SEED = int(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
READY, BUSY, RESULT_VALID = 1, 2, 4
TAKEN, UNREAD, OVERRUN_BUSY = 1, 2, 3
random.seed(SEED)
count = dict(cycles=0, doubled=0, lost=0, late=0, reconnects=0, overruns=0, mixed=0, torn=0, requests=0, slow=0, again=0)


def checksum(registers):
    crc = 0xFFFF
    for byte in struct.pack(f">{len(registers)}H", *registers):
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ 0xA001 if crc & 1 else crc >> 1
    return crc


def pair(registers, at):
    return registers[at] << 16 | registers[at + 1]


class Plc:
    def __init__(self):
        self.client = None
        self.beat = 0
        self.acknowledged = 0
        self.connect()

    def connect(self):
        if self.client:
            self.client.close()
        self.client = ModbusTcpClient("127.0.0.1", port=PORT, timeout=20)
        if not self.client.connect():
            sys.exit("cannot connect")

    def write(self, first, values):
        count["requests"] += 1
        answer = self.client.write_registers(first, values, slave=random.choice((0, 1, 255)))
        if answer.isError():
            sys.exit(f"write: {answer}")

    def read(self):
        count["requests"] += 1
        answer = self.client.read_input_registers(100, 48, slave=1)
        if answer.isError():
            sys.exit(f"read: {answer}")
        registers = answer.registers
        if checksum(registers[20:47]) != registers[47]:
            count["torn"] += 1
        return registers

    def read_again(self, sequence):
        """An earlier result by its number, asked for and read in one request."""
        count["requests"] += 1
        answer = self.client.readwrite_registers(read_address=200, read_count=28, write_address=8,
                                                 write_registers=[sequence >> 16, sequence & 0xFFFF], slave=1)
        if answer.isError():
            sys.exit(f"read again: {answer}")
        if checksum(answer.registers[:27]) != answer.registers[27]:
            count["torn"] += 1
        return answer.registers

    def commands(self, trigger, token):
        """Heartbeat, acknowledge and job in one write, as an I/O scanner has them."""
        self.beat = (self.beat + 1) & 0xFFFF
        return [self.beat, self.acknowledged >> 16, self.acknowledged & 0xFFFF, 0,
                trigger, 0, token >> 16, token & 0xFFFF]

    def break_off(self, commands):
        """The write goes out, and the connection ends before its answer came: nobody knows whether it arrived."""
        request = struct.pack(">HHHBBHHB", 1, 0, 7 + 16, 1, 16, 0, 8, 16) + struct.pack(">8H", *commands)
        self.client.socket.send(request if random.random() < 0.5 else request[: random.randrange(len(request))])
        count["reconnects"] += 1
        self.connect()


plc = Plc()
first = plc.read()
trigger, sequence = first[4], 0
sent, results = [], {}
started = time.time()

for cycle in range(CYCLES):
    token = random.getrandbits(32)
    trigger = trigger % 65535 + 1
    commands = plc.commands(trigger, token)
    kind = random.random()
    if kind < 0.03:  # lost: nothing was sent
        count["lost"] += 1
    elif kind < 0.06:
        plc.break_off(commands)
    else:
        plc.write(0, commands)
    if kind > 0.9:
        plc.write(0, commands)
        count["doubled"] += 1
    if 0.8 < kind < 0.9 and sent:  # of a part before, kept back by a switch
        late = random.choice(sent[-50:])
        plc.write(0, plc.commands(0, 0)[:4] + late[4:])
        count["late"] += 1
    if 0.79 < kind < 0.8:
        time.sleep(random.random() * 0.004)
        count["slow"] += 1
    sent = sent[-50:] + [commands]

    registers = plc.read()
    if registers[4] != trigger:  # it did not arrive
        plc.write(0, commands)
        registers = plc.read()
    if registers[4] != trigger:
        sys.exit(f"trigger {trigger} was not answered: {registers[:14]}")
    if registers[5] in (UNREAD, OVERRUN_BUSY):
        count["overruns"] += 1
        sys.exit("an overrun nobody made")
    if registers[5] != TAKEN:
        sys.exit(f"trigger {trigger} was refused: {registers[:14]}")
    while not registers[2] & RESULT_VALID:
        registers = plc.read()

    sequence += 1
    result = registers[20:48]
    m, k = struct.unpack(">f", struct.pack(">2H", *result[10:12]))[0], struct.unpack(">f", struct.pack(">2H", *result[18:20]))[0]
    if (pair(result, 0), pair(result, 2), result[4]) != (sequence, token, trigger) or result[6] != token % 3 + 1 \
            or m != token % 100003 or k != sequence % 65521:
        count["mixed"] += 1
        print("mixed", cycle, result, token, trigger, sequence, file=sys.stderr)
    count["cycles"] += 1
    results[sequence] = result
    results.pop(sequence - 100, None)
    if random.random() < 0.05:
        asked = random.randrange(max(sequence - 99, 0), sequence + 2)
        kept = asked in results and asked > sequence - 64
        if plc.read_again(asked)[:27] != (results[asked][:27] if kept else [0] * 27):
            count["mixed"] += 1
            print("not the result asked for", cycle, asked, file=sys.stderr)
        count["again"] += 1

    if random.random() < 0.05:  # the acknowledge is forgotten: the next trigger has to be refused, and told
        trigger = trigger % 65535 + 1
        plc.write(0, plc.commands(trigger, random.getrandbits(32)))
        registers = plc.read()
        if registers[4] != trigger or registers[5] != UNREAD:
            sys.exit(f"an overrun was not told: {registers[:14]}")
        if pair(registers, 22) != token:
            count["mixed"] += 1
        count["overruns"] += 1
    plc.acknowledged = sequence
    if random.random() < 0.1:  # on its own, twice, and one that is late; else with the next job
        for value in (sequence, sequence, max(sequence - 1, 0)):
            plc.write(1, [value >> 16, value & 0xFFFF])

plc.write(0, plc.commands(trigger, 0)[:4])
last = plc.read()
count["station_overruns"] = pair(last, 6)
count["station_out_of_step"] = pair(last, 10)
count["station_sequence"] = pair(last, 20)
count["seconds"] = round(time.time() - started, 1)
print(json.dumps(count))
sys.exit(1 if count["mixed"] or count["torn"] or count["station_overruns"] != count["overruns"]
         or count["station_sequence"] != CYCLES else 0)
