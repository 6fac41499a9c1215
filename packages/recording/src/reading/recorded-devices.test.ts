import { expect, it } from 'vitest';

import type { RecordedDevice, RecordingEvent } from '../records/recording-event.ts';
import { recordedDevice, SAMPLE_START_NS } from '../testing/index.ts';
import { devicesInSpan } from './recorded-devices.ts';

const at = (ms: number): bigint => SAMPLE_START_NS + BigInt(ms) * 1_000_000n;
const told = (ms: number, device: RecordedDevice): RecordingEvent<'device'> => ({
  kind: 'device',
  timeNs: at(ms),
  value: device,
});
const phone = (name: string, state = 'registered') =>
  recordedDevice('phone', 'ada', [{ topic: '/ada/tilt' }], { name, state });
const names = (events: readonly RecordingEvent<'device'>[], fromMs: number, untilMs: number) =>
  devicesInSpan(events, { fromNs: at(fromMs), untilNs: at(untilMs) }).map(({ name }) => name);

it('finds devices as they were in the span, each version once', () => {
  const events = [
    told(0, phone('first')),
    told(100, phone('second')),
    told(150, phone('second')),
    told(300, phone('third')),
  ];
  expect(names(events, 0, 50)).toEqual(['first']);
  expect(names(events, 100, 200)).toEqual(['second']);
  expect(names(events, 50, 300)).toEqual(['first', 'second', 'third']);
  expect(names(events, 400, 500)).toEqual(['third']);
});

it('leaves out devices that were gone, and those that came afterwards', () => {
  const events = [told(100, phone('first')), told(200, phone('first', 'deregistered'))];
  expect(names(events, 0, 99)).toEqual([]);
  expect(names(events, 150, 500)).toEqual(['first']);
  expect(names(events, 201, 500)).toEqual([]);
});
