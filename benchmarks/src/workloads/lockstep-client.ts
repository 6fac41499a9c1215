import { encodeRecord, type EmptyRecord, type TopicRecord } from '@ubii/proto';
import type { MasterProcess } from '@ubii/harness';

import { joinMaster } from '../brokers/brokers.ts';
import { OPCODE, clientFrame } from '../load/frames.ts';
import { RecordReceiver } from '../load/record-receiver.ts';

const MAX_SENTENCES = 5;

/**
 * Checks the outputs of lockstep modules: every pass has one of each, in the order of the modules, with
 * the input they were given.
 */
export class PassWatch {
  readonly faults: string[] = [];
  /** Passes that are complete. */
  passes = 0;
  readonly #places: ReadonlyMap<string, number>;
  readonly #input: number;
  /** Place of the output that comes next. */
  #next = 0;
  #pass: number | undefined;

  /**
   * @param topics of the outputs, in the order of the modules
   * @param input what the modules find on their input
   */
  constructor(topics: readonly string[], input: number) {
    this.#places = new Map(topics.map((topic, place) => [topic, place]));
    this.#input = input;
  }

  /** Returns false for a record of another client. */
  handleRecord({ topic, value }: TopicRecord | EmptyRecord): boolean {
    const place = this.#places.get(topic);
    if (place === undefined) return false;
    const { x: pass, y: input } = value as { x: number; y: number };
    this.#pass ??= pass;
    if (place !== this.#next || pass !== this.#pass) {
      this.#report(
        `output ${place} of pass ${pass} where ${this.#next} of ${this.#pass} was to come`,
      );
    }
    if (input !== this.#input) this.#report(`a module found ${input} instead of ${this.#input}`);
    this.#next = place + 1;
    this.#pass = pass;
    if (this.#next < this.#places.size) return true;
    this.#next = 0;
    this.#pass += 1;
    this.passes += 1;
    return true;
  }

  #report(sentence: string): void {
    if (this.faults.length < MAX_SENTENCES) this.faults.push(`unexpected: ${sentence}`);
  }
}

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
