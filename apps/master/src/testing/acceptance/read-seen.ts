import { decodeTopicData } from '@ubii/proto';
import { scanTopicData, type TimedPong } from '@ubii/proto/wire';
import { closeFrame } from '../../adapters/ws/close-codes.ts';
import { CLOSE_REASONS } from '../../core/ports/close-reason.ts';
import type { Seen } from './connection-bench.ts';

/** Tag of `TopicData.topic_data_record_list`. */
const LIST_TAG = 26;

/** A message of topic data, as a client sees it. */
export function readTopicData(message: Uint8Array): Seen {
  const { error, nodeMessages } = decodeTopicData(message);
  if (nodeMessages.length > 0) return { kind: 'frame', frame: message };
  if (error !== undefined) return { kind: 'error', error };
  const records: Uint8Array[] = [];
  scanTopicData(message, {
    record: (_topic, start, end) => records.push(message.subarray(start, end)),
    error: () => {},
  });
  const [record = new Uint8Array()] = records;
  return message[0] === LIST_TAG ? { kind: 'list', records } : { kind: 'record', record };
}

/** A text, as a client sees it. */
export function readText(text: string): Seen {
  if (text === 'PING') return { kind: 'PING' };
  const [pong, number, receivedMs, sentMs] = text.split(' ');
  if (pong !== 'PONG') throw new Error(`no heartbeat: ${text}`);
  if (number === undefined) return { kind: 'PONG' };
  const timed: TimedPong = { number, receivedMs: Number(receivedMs), sentMs: Number(sentMs) };
  return { kind: 'PONG', timed };
}

/** The close of a channel that says why by codes, as WebSockets do. */
export function readClose(code: number, text: string): Seen {
  const reason = CLOSE_REASONS.find((one) => closeFrame(one).code === code);
  if (reason === undefined) throw new Error(`no reason of the master: ${code} ${text}`);
  const isNamed = closeFrame(reason).text === text;
  return { kind: 'close', reason, ...(!isNamed && { explanation: text }) };
}

/** The text of a PING. */
export function pingText(timed?: { number: string; clock?: object | undefined }): string {
  if (timed === undefined) return 'PING';
  return ['PING', timed.number, ...Object.values(timed.clock ?? {})].join(' ');
}
