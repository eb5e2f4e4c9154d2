#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A primary host that shares no line with the program: it reads protobuf by its wire format and holds an edge node to
Sparkplug B 3.0. sparkplug_host.py PORT RESULTS: ends when it has seen so many by both, JSON and Sparkplug, and prints what
it saw as one JSON object; "faults" is what the node did wrong."""
import json
import struct
import sys
import threading
import time

import paho.mqtt.client as mqtt

PORT, RESULTS = int(sys.argv[1]), int(sys.argv[2])
NODE, STATE, JSON_TOPIC = "spBv1.0/plant/%s/station", "spBv1.0/STATE/scada", "plant/results"
VALUE_FIELD = {6: 10, 7: 10, 8: 11, 10: 13, 11: 14, 12: 15, 13: 11}  # by datatype


def varint(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        value |= (byte & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if byte < 0x80:
            return value, at


def fields(data):
    at, found = 0, []
    while at < len(data):
        key, at = varint(data, at)
        if key & 7 == 0:
            value, at = varint(data, at)
        elif key & 7 == 1:
            value, at = struct.unpack_from("<d", data, at)[0], at + 8
        elif key & 7 == 2:
            length, at = varint(data, at)
            value, at = data[at:at + length], at + length
        else:
            raise ValueError("wire type %d" % (key & 7))
        found.append((key >> 3, value))
    return found


class Node:
    """What an edge node has said in its session."""

    def __init__(self):
        self.faults, self.births, self.rebirths, self.deaths = [], [], 0, 0
        self.sparkplug, self.json, self.doubled = {}, {}, 0
        self.asked = 0  # for a rebirth
        self.forget()

    def forget(self):
        self.seq, self.metrics, self.bdseq = None, {}, None

    def fault(self, text):
        if len(self.faults) < 20:
            self.faults.append(text)

    def next_seq(self, kind, payload):
        seq = dict(payload).get(3)
        if self.seq is not None and seq != (self.seq + 1) % 256:
            self.fault("%s with seq %s behind %s" % (kind, seq, self.seq))
        self.seq = seq

    def hear(self, kind, device, data, qos, retain):
        payload = fields(data)
        metrics = [dict(fields(value)) for number, value in payload if number == 2]
        if retain or qos != (1 if kind == "NDEATH" else 0):
            self.fault("%s with QoS %d, retain %s" % (kind, qos, retain))
        if kind == "NDEATH":
            return self.node_death(payload, metrics)
        if abs(dict(payload).get(1, 0) / 1000 - time.time()) > 600:
            self.fault("%s without the time of now" % kind)
        if kind == "NBIRTH":
            return self.node_birth(payload, metrics)
        if self.bdseq is None:
            return None  # of a session that was begun before this host was there
        self.next_seq(kind, payload)
        if kind == "DBIRTH":
            return self.device_birth(device, metrics)
        if kind == "DDEATH":
            self.metrics.pop(device, None)
            return None
        return self.device_data(device, metrics)

    def node_birth(self, payload, metrics):
        named = {metric[1]: metric for metric in metrics}
        if dict(payload).get(3) != 0:
            self.fault("NBIRTH with seq %s" % dict(payload).get(3))
        if named[b"bdSeq"][4] != 8 or named[b"Node Control/Rebirth"][4] != 11 or named[b"Node Control/Rebirth"][14] != 0:
            self.fault("NBIRTH without bdSeq or Rebirth of their types")
        bdseq = named[b"bdSeq"][11]
        if self.bdseq == bdseq:
            self.rebirths += 1
        else:
            self.births.append(bdseq)
        self.seq, self.bdseq, self.metrics = 0, bdseq, {}

    def node_death(self, payload, metrics):
        self.deaths += 1
        if 3 in dict(payload) or metrics[0][1] != b"bdSeq":
            self.fault("NDEATH with seq, or without bdSeq")
        if self.bdseq is not None and metrics[0][11] == self.bdseq:
            self.forget()

    def device_birth(self, device, metrics):
        known = {}
        for metric in metrics:
            if not {1, 2, 3, 4} <= metric.keys() or not (7 in metric or VALUE_FIELD[metric[4]] in metric):
                self.fault("DBIRTH with a metric without name, alias, timestamp, datatype or value")
            known[metric[2]] = (metric[1].decode(), metric[4])
        for other, theirs in self.metrics.items():
            if other != device and set(theirs) & set(known):
                self.fault("an alias of two devices")
        self.metrics[device] = known

    def device_data(self, device, metrics):
        if device not in self.metrics:
            return self.fault("DDATA of %s before its DBIRTH" % device)
        values, historical = {}, set()
        for metric in metrics:
            if metric.get(2) not in self.metrics[device] or 1 in metric or 3 not in metric:
                return self.fault("DDATA with an alias that was not born, a name, or no timestamp")
            name, datatype = self.metrics[device][metric[2]]
            if 7 not in metric and VALUE_FIELD[datatype] not in metric:
                self.fault("DDATA with %s of another type" % name)
            values[name] = metric.get(VALUE_FIELD[datatype])
            historical.add(bool(metric.get(5, 0)))
        if len(historical) != 1:
            self.fault("a result that is historical in parts")
        return self.take(self.sparkplug, values["Sequence"], historical.pop(), values["Part"].decode())

    def take(self, where, sequence, historical, part):
        if part != "P%d" % sequence:
            self.fault("result %d of part %s" % (sequence, part))
        if sequence in where:
            self.doubled += 1
        elif where and sequence < max(where):
            self.fault("result %d behind %d" % (sequence, max(where)))
        else:
            where[sequence] = historical
        return None


node, lock, done = Node(), threading.Lock(), threading.Event()


def heard(client, _, message):
    with lock:
        try:
            if message.topic == JSON_TOPIC:
                result = json.loads(message.payload)
                node.take(node.json, result["sequence"], result["historical"], result["part"])
            elif not message.topic.startswith("spBv1.0/STATE/"):
                parts = message.topic.split("/")
                if parts[2] != "NCMD":
                    node.hear(parts[2], parts[4] if len(parts) > 4 else None, message.payload, message.qos, message.retain)
        except Exception as problem:  # pylint: disable=broad-except
            node.fault("%s: %r" % (message.topic, problem))
        if len(node.json) >= RESULTS // 2 and node.rebirths == 0 and time.time() > node.asked + 0.2:
            node.asked = time.time()
            rebirth = bytes([0x0A, 20]) + b"Node Control/Rebirth" + bytes([0x20, 11, 0x70, 1])
            host.publish(NODE % "NCMD", bytes([0x12, len(rebirth)]) + rebirth)
        if len(node.json) >= RESULTS and len(node.sparkplug) >= RESULTS and node.rebirths > 0:
            done.set()


def state(online, when):
    return json.dumps({"online": online, "timestamp": when})


def host_connected(client, *_):
    with lock:
        node.forget()
    client.subscribe("spBv1.0/plant/#", 1)
    client.publish(STATE, state(True, client.came), 1, True)


def keep_connected(client, before):
    while not done.is_set():
        try:
            before(client)
            client.connect("127.0.0.1", PORT, 20)
            while client.loop(0.05) == 0 and not done.is_set():
                pass
        except OSError:
            pass
        time.sleep(0.03)


def host_before(client):
    client.came = int(time.time() * 1000)
    client.will_set(STATE, state(False, client.came), 1, True)


host = mqtt.Client("scada", clean_session=True)
host.on_connect, host.on_message = host_connected, heard
listener = mqtt.Client("listener", clean_session=False)  # the broker keeps for it what it misses
listener.on_message = heard
listener.on_connect = lambda client, *_: client.subscribe(JSON_TOPIC, 1)
threads = [threading.Thread(target=keep_connected, args=pair, daemon=True)
           for pair in ((host, host_before), (listener, lambda client: None))]
for thread in threads:
    thread.start()
print("ready", flush=True)
done.wait(300)
for thread in threads:
    thread.join(2)
print(json.dumps({"faults": node.faults, "births": node.births, "rebirths": node.rebirths, "deaths": node.deaths,
                  "doubled": node.doubled, "json": sorted(node.json.items()), "sparkplug": sorted(node.sparkplug.items())}))
