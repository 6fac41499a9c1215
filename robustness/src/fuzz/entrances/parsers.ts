import {
  decode,
  DecodeError,
  decodeRecord,
  decodeTopicData,
  encode,
  findJsonProblems,
  fromJson,
  parseDataFormat,
  toJson,
  type MessageType,
} from '@ubii/proto';
import { readNodeMessage, readRecordHead, scanTopicData } from '@ubii/proto/wire';

import type { Entrance } from '../entrance.ts';
import { mutateBytes } from '../mutate-bytes.ts';
import { mutateJson } from '../mutate-json.ts';
import { mutateWire } from '../mutate-wire.ts';
import { fromBase64, readSeeds } from '../seeds.ts';

const TYPES: readonly MessageType[] = [
  'ubii.services.ServiceRequest',
  'ubii.services.ServiceReply',
  'ubii.topicData.TopicData',
  'ubii.topicData.TopicDataRecord',
  'ubii.sessions.Session',
  'ubii.processing.ProcessingModule',
  'ubii.clients.Client',
  'ubii.devices.Device',
];

/** The codec in this process: millions of inputs, and nothing but `DecodeError` may come out. */
export const codec: Entrance = {
  name: 'codec',
  about: 'the codec of packages/proto, in this process: protobuf, frames, records',
  kind: 'parser',
  seeds: () => [...fromBase64(readSeeds().requests), ...fromBase64(readSeeds().frames)],
  mutate: (random, seed, other) =>
    random.oneIn(4) ? mutateBytes(random, seed, other) : mutateWire(random, seed, other),
  async deliver(input) {
    await Promise.resolve();
    for (const type of TYPES) {
      allowing(() => {
        const message = decode(type, input);
        // Every decoded message can be encoded, and decoded again.
        const again = encode(type, message as never);
        decode(type, again);
        fromJson(type, JSON.parse(JSON.stringify(toJson(type, message as never))));
      });
    }
    // These report what is wrong instead of throwing it.
    decodeTopicData(input);
    allowing(() => decodeRecord(input));
    allowing(() => readRecordHead(input));
    allowing(() =>
      scanTopicData(
        input,
        new Proxy({} as Parameters<typeof scanTopicData>[1], { get: () => () => {} }),
      ),
    );
    allowing(() => readNodeMessage(input));
  },
};

export const jsonCodec: Entrance = {
  name: 'json-codec',
  about: 'the JSON form of messages, in this process',
  kind: 'parser',
  seeds: () =>
    fromBase64(readSeeds().requests).map((bytes) => {
      const request = decode('ubii.services.ServiceRequest', bytes);
      return Buffer.from(JSON.stringify(toJson('ubii.services.ServiceRequest', request)));
    }),
  mutate(random, seed) {
    const text = JSON.stringify(mutateJson(random, JSON.parse(Buffer.from(seed).toString())));
    return new Uint8Array(Buffer.from(text ?? 'null'));
  },
  async deliver(input) {
    await Promise.resolve();
    const json: unknown = JSON.parse(Buffer.from(input).toString());
    for (const type of TYPES) {
      allowing(() => {
        const message = fromJson(type, json);
        decode(type, encode(type, message as never));
      });
      findJsonProblems(type, json);
    }
    parseDataFormat(Buffer.from(input).toString().slice(0, 200));
  },
};

/** @throws what is no documented error */
function allowing(parse: () => unknown): void {
  try {
    parse();
  } catch (error) {
    if (!(error instanceof DecodeError)) throw error;
  }
}
