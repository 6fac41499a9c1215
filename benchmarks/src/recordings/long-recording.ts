import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { encodeRecord, TouchEventType, type RecordInit } from '@ubii/proto';
import { RecordingWriter } from '@ubii/recording';
import { DiskFile } from '@ubii/recording/node';
import { SAMPLE_HEADER, SAMPLE_START_NS } from '@ubii/recording/testing';
import type { Part } from '../parts/shared-parts.ts';

export const TOPICS = 200;
export const MINUTES = 60;
/** Between two records of a topic, milliseconds. */
const PERIOD_MS = 500;
const NS_PER_MS = 1_000_000n;
const TEXTS = ['rest', 'swipe', 'tap', 'circle'];

/** A recording on disk, deleted at the end. */
export interface LongRecording extends Part {
  readonly path: string;
  readonly records: number;
}

type Kind = (topic: string, timeMs: number, index: number) => RecordInit;

/** Values of a topic by time, of the kinds that a timeline draws: lines, texts, bars and events. */
const KINDS: readonly Kind[] = [
  (topic, t, i) => {
    const value = { x: Math.sin(t / 900 + i), y: Math.cos(t / 700), z: i };
    return { topic, format: 'vector3', value };
  },
  (topic, t, i) => ({ topic, format: 'double', value: Math.sin(t / (1000 + i)) }),
  (topic, t) => {
    const value = { x: Math.sin(t / 3000), y: 0, z: 0, w: Math.cos(t / 3000) };
    return { topic, format: 'quaternion', value };
  },
  (topic, t, i) => {
    const value = TEXTS[Math.floor(t / 4000 + i) % TEXTS.length]!;
    return { topic, format: 'string', value };
  },
  (topic, t, i) => {
    const names = (t / 10_000 + i) % 2 < 1 ? ['person', 'cup'] : ['person'];
    return { topic, format: 'object2DList', value: { elements: names.map((id) => ({ id })) } };
  },
  (topic, t) => {
    const type = t % 2000 < 1000 ? TouchEventType.TOUCH_START : TouchEventType.TOUCH_END;
    return { topic, format: 'touchEvent', value: { type, position: { x: 0.5, y: 0.5 } } };
  },
];

/** Writes an hour of all topics. */
export async function writeLongRecording(): Promise<LongRecording> {
  const folder = await mkdtemp(join(tmpdir(), 'ubii-long-recording-'));
  const path = join(folder, 'hour.mcap');
  const file = await DiskFile.create(path);
  const writer = await RecordingWriter.create(file, { ...SAMPLE_HEADER, name: 'An hour' });
  for (let timeMs = 0; timeMs <= MINUTES * 60_000; timeMs += PERIOD_MS) {
    const logTimeNs = SAMPLE_START_NS + BigInt(timeMs) * NS_PER_MS;
    for (let index = 0; index < TOPICS; index++) {
      const topic = `/device-${index}/value`;
      const record = encodeRecord(KINDS[index % KINDS.length]!(topic, timeMs, index));
      const times = { logTimeNs, publishTimeNs: logTimeNs };
      await writer.addRecord({ topic, clientId: 'ada', record, ...times });
    }
  }
  await writer.end();
  await file.close();
  const { records } = writer.statistics;
  return { path, records, stop: () => rm(folder, { recursive: true }) };
}
