import type { EmptyRecord, TopicRecord } from '@ubii/proto';
import type { BrokerClient, ClientRole } from '../brokers/target.ts';
import type { StreamReceiver } from '../load/load-connection.ts';
import { RecordReceiver } from '../load/record-receiver.ts';
import { RING_RECORDS, type RecordRing } from '../load/record-ring.ts';
import type { Callee } from './call-series.ts';

type Echo = TopicRecord | EmptyRecord;

/**
 * One client that publishes the records of a ring one by one, and waits for each to come back on
 * `answerTopic`.
 */
export async function openEcho(
  join: (role: ClientRole, receiver: StreamReceiver) => Promise<BrokerClient>,
  ring: RecordRing,
  answerTopic: string,
): Promise<Callee<Buffer, Echo[]>> {
  const receiver = new RecordReceiver();
  let settle: { resolve(records: Echo[]): void; reject(reason: Error): void } | undefined;
  let arrived: Echo[] = [];
  // The clock is read when the frame is there; it is read itself and checked after that.
  receiver.onFrame = () => {
    arrived = [];
    settle?.resolve(arrived);
    settle = undefined;
  };
  receiver.onRecord = (record) => arrived.push(record);
  receiver.onEnd = (reason) => settle?.reject(new Error(reason));
  const { connection } = await join({ publishes: true, topics: [answerTopic] }, receiver);
  return {
    sequence: 0,
    prepare: (sequence) => ring.published.slice(sequence, 1),
    call: (frame) =>
      new Promise((resolve, reject) => {
        settle = { resolve, reject };
        connection.send(frame);
      }),
    isRight: (records, sequence) =>
      records.length === 1 && isRecordOf(records[0]!, answerTopic, sequence),
    abandon: (reason) => settle?.reject(reason),
    takeFaults: () => receiver.faults.splice(0),
  };
}

/** See `createRecordRing`. */
function isRecordOf({ topic, value }: Echo, answerTopic: string, sequence: number): boolean {
  const number = sequence % RING_RECORDS;
  const { x, y, z } = value as { x: number; y: number; z: number };
  return topic === answerTopic && x === number && y === Math.sin(number) && z === Math.cos(number);
}
