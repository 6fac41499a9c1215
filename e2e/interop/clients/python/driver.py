"""Drives the published ubii-node-python: JSON lines on stdin (commands) and stdout (replies, events)."""

import asyncio
import json
import logging
import os
import sys
import traceback
import warnings

_out = os.fdopen(os.dup(1), "w", buffering=1)
os.dup2(2, 1)  # whatever the client prints goes to stderr
warnings.simplefilter("ignore")
logging.basicConfig(stream=sys.stderr, level=logging.WARNING)

import aiohttp  # noqa: E402
import ubii.proto  # noqa: E402
from google.protobuf.json_format import MessageToDict  # noqa: E402
from ubii.framework.client import InitProcessingModules  # noqa: E402
from ubii.node import Devices, Publish, Services, Subscriptions, connect_client  # noqa: E402

from modules import MODULES  # noqa: E402


def write_line(message):
    _out.write(json.dumps(message) + "\n")
    _out.flush()


def emit(event, **fields):
    write_line({"event": event, **fields})


def to_plain(message):
    return MessageToDict(
        type(message).pb(message), including_default_value_fields=True, use_integers_for_enums=False
    )


class _Complaints(logging.Handler):
    """Everything the client logs as an error is told to the test."""

    def emit(self, record):
        emit("complaint", text=self.format(record))


logging.getLogger().addHandler(_Complaints(level=logging.ERROR))


def _watch_frames():
    """Tells the test what kind of frame came, before the client itself reads it."""
    receive = aiohttp.ClientWebSocketResponse.receive

    async def watched(self, *args, **kwargs):
        message = await receive(self, *args, **kwargs)
        if message.type == aiohttp.WSMsgType.TEXT:
            emit("frame", kind="ping" if message.data == "PING" else "text", text=message.data)
        elif message.type == aiohttp.WSMsgType.BINARY:
            data = ubii.proto.TopicData.deserialize(message.data)
            member = ubii.proto.TopicData.pb(data).WhichOneof("type")
            kinds = {"topic_data_record": "record", "topic_data_record_list": "list"}
            emit("frame", kind=kinds.get(member, member or "empty"))
        elif message.type in (aiohttp.WSMsgType.CLOSE, aiohttp.WSMsgType.CLOSED):
            emit("close", code=self.close_code or 0, reason=str(message.extra or ""))
        return message

    aiohttp.ClientWebSocketResponse.receive = watched


def emit_record(subscription):
    def on_record(record):
        pb = ubii.proto.TopicDataRecord.pb(record)
        member = pb.WhichOneof("type")
        value = getattr(pb, member) if member else None
        if hasattr(value, "DESCRIPTOR"):
            value = MessageToDict(value, including_default_value_fields=True)
        emit("record", subscription=subscription, topic=record.topic, format=member, value=value)

    return on_record


class Driver:
    def __init__(self):
        self._connection = None
        self._client = None

    async def connect(self, services, name, modules=False, **_):
        self._connection = connect_client(services)
        self._connection.client.name = name
        if modules:
            self._connection.client.is_dedicated_processing_node = True
            self._connection.client[InitProcessingModules].module_factories = MODULES
        self._client = await self._connection.__aenter__()
        while self._client.protocol.state.value != self._client.protocol.state.value.CONNECTED:
            await self._client.protocol.state.get(predicate=lambda s: s == s.CONNECTED)
        context = self._client.protocol.context
        return {
            "clientId": self._client.id,
            "client": {"id": self._client.id, "name": self._client.name},
            "server": to_plain(context.server),
            "subscriptionTopic": context.constants.DEFAULT_TOPICS.SERVICES.TOPIC_SUBSCRIPTION,
            "servicesUrl": context.service_connection.url,
        }

    async def callService(self, name):
        """Calls a service that takes no payload, by the client's own short name for it."""
        return to_plain(await getattr(self._client[Services].service_map, name)())

    async def registerDevice(self, device):
        registered = ubii.proto.Device(device)
        await self._client[Devices].register_device(registered)
        return to_plain(registered)

    async def subscribeTopic(self, topic):
        await self._client[Subscriptions].subscribe_topic(topic).with_callback(emit_record(topic))

    async def subscribeRegex(self, regex):
        await self._client[Subscriptions].subscribe_regex(regex).with_callback(emit_record(regex))

    async def publish(self, records, immediately=False):
        records = [ubii.proto.TopicDataRecord(record) for record in records]
        if immediately:
            for record in records:
                await self._client[Publish].publish(record)
        else:
            await self._client[Publish].publish(*records)

    async def disconnect(self):
        await self._connection.__aexit__(None, None, None)


async def main():
    _watch_frames()
    driver = Driver()
    loop = asyncio.get_running_loop()
    reader = asyncio.StreamReader(limit=2**24)
    await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)
    emit("ready")

    async def answer(message):
        try:
            result = await getattr(driver, message["command"])(**message.get("params") or {})
            write_line({"id": message["id"], "result": result})
        except Exception:  # the test decides what an error means
            write_line({"id": message["id"], "error": traceback.format_exc()})

    pending = set()
    while line := await reader.readline():
        task = asyncio.create_task(answer(json.loads(line)))
        pending.add(task)
        task.add_done_callback(pending.discard)


asyncio.run(main())
