import { DATA_FORMATS, dataFormatOfField, encodeRecord } from '@ubii/proto';
import type { DataFormat, RecordInit } from '@ubii/proto';
import type { WaitingRecord } from './publish-buffer.ts';

/** A record as a program publishes it. */
export interface Publication {
  readonly topic: string;
  readonly format: DataFormat;
  readonly value: unknown;
  /** Milliseconds since the Unix epoch. */
  readonly timestampMs: number;
  /** Empty before the first connection. */
  readonly clientId: string;
  /** Time for which the value outlives this client, seconds. [TD-43] */
  readonly keepSeconds?: number | undefined;
  /** Expiry of the value without a newer one, milliseconds. [TD-47] */
  readonly expiryMs?: number | undefined;
}

/**
 * Checks and encodes a publication, at once, so that the program may go on changing its value.
 * @throws {TypeError} if the topic is empty, or the value does not fit the format
 * @throws {RangeError} if `keepSeconds` or `expiryMs` is not a whole number from 0 to 2^31 - 1
 */
export function toWaitingRecord(publication: Publication): WaitingRecord {
  const { topic, format, value } = publication;
  checkTopic(topic);
  const info = Object.hasOwn(DATA_FORMATS, format) ? DATA_FORMATS[format] : undefined;
  if (info === undefined) throw new TypeError(`Expected a data format, received "${format}"`);
  checkWhole('keepSeconds', publication.keepSeconds);
  checkWhole('expiryMs', publication.expiryMs);
  const problem = info.validate(value);
  if (problem !== undefined) throw new TypeError(`${topic}: ${problem}`);
  return { topic, bytes: encodeRecord(publication as RecordInit), isEvent: info.isEvent };
}

/**
 * The record that ends a topic: no value, and nothing of it stays on the master. [TD-48]
 * @throws {TypeError} if the topic is empty
 */
export function endingRecord({
  topic,
  timestampMs,
  clientId,
}: Pick<Publication, 'topic' | 'timestampMs' | 'clientId'>): WaitingRecord {
  checkTopic(topic);
  const bytes = encodeRecord({ topic, timestampMs, clientId, expiryMs: 1 });
  return { topic, bytes, isEvent: false };
}

function checkTopic(topic: unknown): void {
  if (typeof topic === 'string' && topic !== '') return;
  throw new TypeError(`Expected a topic to publish on, received ${JSON.stringify(topic)}`);
}

function checkWhole(name: string, value = 0): void {
  if (Number.isInteger(value) && value >= 0 && value < 2 ** 31) return;
  throw new RangeError(`Expected ${name} to be a whole number, 0 or more, received ${value}`);
}

/** A record that was encoded elsewhere, and is not looked at. */
export function waitingRecordOf(
  topic: string,
  bytes: Uint8Array,
  valueField: number,
): WaitingRecord {
  const format = dataFormatOfField(valueField);
  return { topic, bytes, isEvent: format !== undefined && DATA_FORMATS[format].isEvent };
}
