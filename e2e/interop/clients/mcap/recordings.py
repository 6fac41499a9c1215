"""Reads and writes recordings with published packages: `read` and `xdf` print a file as JSON, `write` makes an MCAP file."""

import json
import sys

from google.protobuf.json_format import MessageToDict
from mcap.reader import make_reader
from mcap.writer import Writer
from mcap_protobuf.decoder import DecoderFactory
from pyxdf import load_xdf


def read(path):
    with open(path, "rb") as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        records = []
        events = []
        for schema, channel, message in reader.iter_messages():
            if schema.encoding == "jsonschema":
                events.append({"topic": channel.topic, "value": json.loads(message.data)})
        summary = reader.get_summary()
        topics = [channel.topic for channel in summary.channels.values()]
        topics = [topic for topic in topics if not topic.startswith("/recording/")]
        for decoded in reader.iter_decoded_messages(topics=topics):
            records.append(
                {
                    "topic": decoded.channel.topic,
                    "clientName": decoded.channel.metadata["clientName"],
                    "type": decoded.decoded_message.DESCRIPTOR.full_name,
                    "logTime": str(decoded.message.log_time),
                    "publishTime": str(decoded.message.publish_time),
                    "value": MessageToDict(decoded.decoded_message),
                }
            )
        metadata = {record.name: record.metadata for record in reader.iter_metadata()}
        statistics = summary.statistics
        return {
            "profile": reader.get_header().profile,
            "metadata": metadata,
            "messages": statistics.message_count,
            "chunks": statistics.chunk_count,
            "records": records,
            "events": events,
        }


def xdf(path):
    streams, _ = load_xdf(path, dejitter_timestamps=False)
    return {
        "streams": [
            {
                "name": stream["info"]["name"][0],
                "format": stream["info"]["channel_format"][0],
                "times": [float(time) for time in stream["time_stamps"]],
                "values": [list(sample) for sample in stream["time_series"]],
            }
            for stream in streams
        ]
    }


def write(path):
    with open(path, "wb") as file:
        writer = Writer(file, chunk_size=4_000)
        writer.start(profile="", library="interop")
        schema = json.dumps({"type": "object"}).encode()
        schema_id = writer.register_schema("sample", "jsonschema", schema)
        channel_id = writer.register_channel("/foreign", "json", schema_id)
        for i in range(1_000):
            time = 1_750_000_000_000_000_000 + i * 1_000_000
            data = json.dumps({"i": i, "text": "x" * (i % 50)}).encode()
            writer.add_message(channel_id, log_time=time, data=data, publish_time=time - 5)
        writer.finish()
    return {}


command, path = sys.argv[1:]
print(json.dumps({"read": read, "write": write, "xdf": xdf}[command](path)))
