import type { MasterProcess } from '@ubii/harness';
import { encodeRecord, type EmptyRecord, type TopicRecord } from '@ubii/proto';
import { joinMaster } from '../brokers/brokers.ts';
import { OPCODE, clientFrame } from '../load/frames.ts';
import { RecordReceiver } from '../load/record-receiver.ts';

const ANSWER_TIMEOUT_MS = 5_000;

type AnyRecord = TopicRecord | EmptyRecord;

/** One client that publishes what it likes, and waits for single records. */
export interface LockstepClient {
  readonly receiver: RecordReceiver;
  publish(frame: Buffer): void;
  /** Publishes, and resolves with the first record on `topic`. */
  ask(frame: Buffer, topic: string): Promise<AnyRecord>;
  /** Takes all other records. */
  onRecord: (record: AnyRecord) => void;
  leave(): Promise<void>;
}

export async function joinAsClient(
  master: MasterProcess,
  topics: readonly string[],
): Promise<LockstepClient> {
  const receiver = new RecordReceiver();
  let awaited: { topic: string; resolve(record: AnyRecord): void } | undefined;
  const { connection, leave } = await joinMaster(
    master,
    { publishes: true, topics },
    receiver,
    true,
  );
  const client: LockstepClient = {
    receiver,
    publish: (frame) => connection.send(frame),
    ask: (frame, topic) =>
      new Promise((resolve, reject) => {
        const timer = setTimeout(
          () => reject(new Error(`there was no answer on ${topic}`)),
          ANSWER_TIMEOUT_MS,
        );
        awaited = {
          topic,
          resolve: (record) => {
            clearTimeout(timer);
            resolve(record);
          },
        };
        connection.send(frame);
      }),
    onRecord: () => {},
    leave,
  };
  receiver.onRecord = (record) => {
    if (record.topic !== awaited?.topic) return client.onRecord(record);
    const { resolve } = awaited;
    awaited = undefined;
    resolve(record);
  };
  return client;
}

/** A frame with one vector, whose first number is given. */
export function vectorFrame(topic: string, x: number): Buffer {
  return frameOf(encodeRecord({ topic, format: 'vector3', value: { x, y: 0, z: 0 } }));
}

/** A frame with one number. */
export function numberFrame(topic: string, value: number): Buffer {
  return frameOf(encodeRecord({ topic, format: 'double', value }));
}

const TOPIC_DATA_RECORD_TAG = 0x12;

function frameOf(record: Uint8Array): Buffer {
  if (record.length > 0x7f)
    throw new RangeError(`Expected a short record, got ${record.length} B.`);
  const message = Buffer.concat([Buffer.from([TOPIC_DATA_RECORD_TAG, record.length]), record]);
  return clientFrame(OPCODE.binary, message);
}
