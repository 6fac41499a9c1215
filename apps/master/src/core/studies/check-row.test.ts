import { StudyCheckKind, StudyCheckState, type StudyDevice } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { checkRow, troublesOf, type DeviceFacts } from './check-row.ts';

const { STUDY_CHECK_STATE_OK: OK, STUDY_CHECK_STATE_MISSING: MISSING } = StudyCheckState;
const LOW = StudyCheckState.STUDY_CHECK_STATE_LOW;

const required = (change: Partial<StudyDevice> = {}): StudyDevice => ({
  name: 'Phone',
  topicPattern: '',
  dataFormat: '',
  tag: 'phone',
  count: 1,
  minRateHz: 0,
  minBattery: 0,
  maxClockErrorMs: 0,
  ...change,
});
const phone = (change: Partial<DeviceFacts> = {}): DeviceFacts => ({
  name: 'Ada',
  rateHz: 60,
  battery: 0.8,
  clockErrorMs: 2,
  ...change,
});
const all = { minRateHz: 30, minBattery: 0.5, maxClockErrorMs: 5 };

/** State of the row, and texts of what is not OK. */
function check(device: StudyDevice, ...found: DeviceFacts[]) {
  const row = checkRow(device, found);
  return [row.state, troublesOf([row])];
}

describe('a row of the check list', () => {
  it('is missing as long as fewer than needed are there [ST-30]', () => {
    expect(check(required())).toEqual([MISSING, 'Phone: 0 of 1 found']);
    expect(check(required({ count: 2 }), phone())).toEqual([MISSING, 'Phone: 1 of 2 found']);
    expect(check(required({ count: 2 }), phone(), phone())).toEqual([OK, '']);
  });

  it('has an item for each requirement that the study has, with values [ST-30]', () => {
    expect(checkRow(required(all), [phone()])).toEqual({
      name: 'Phone',
      state: OK,
      found: ['Ada'],
      items: [
        { kind: StudyCheckKind.STUDY_CHECK_KIND_PRESENCE, state: OK, text: '1 of 1 found' },
        { kind: StudyCheckKind.STUDY_CHECK_KIND_RATE, state: OK, text: '60 Hz (at least 30 Hz)' },
        { kind: StudyCheckKind.STUDY_CHECK_KIND_BATTERY, state: OK, text: '80 % (at least 50 %)' },
        {
          kind: StudyCheckKind.STUDY_CHECK_KIND_CLOCK,
          state: OK,
          text: '2 ms (at most 5 ms)',
        },
      ],
    });
  });

  it.each([
    [{ rateHz: 29.9 }, LOW, 'Phone: rate 29 Hz (at least 30 Hz)'],
    [{ rateHz: 0 }, LOW, 'Phone: rate 0 Hz (at least 30 Hz)'],
    [{ rateHz: undefined }, MISSING, 'Phone: rate not known'],
    [{ battery: 0.499 }, LOW, 'Phone: battery 49 % (at least 50 %)'],
    [{ battery: undefined }, MISSING, 'Phone: battery not reported'],
    [{ clockErrorMs: 12.5 }, LOW, 'Phone: clock error 12 ms (at most 5 ms)'],
    [{ clockErrorMs: undefined }, MISSING, 'Phone: clock error not reported'],
    [
      { rateHz: 1.239, battery: undefined },
      MISSING,
      'Phone: rate 1.23 Hz (at least 30 Hz), battery not reported',
    ],
  ])('of a device with %o has state %i [ST-30]', (change, state, text) => {
    expect(check(required(all), phone(change))).toEqual([state, text]);
  });

  it('does not ask for what the study does not require [ST-30]', () => {
    const facts = { rateHz: undefined, battery: undefined, clockErrorMs: undefined };
    expect(check(required(), phone(facts))).toEqual([OK, '']);
  });

  it('takes the best of those that are there, and of them the worst value [ST-30]', () => {
    const device = required({ ...all, count: 2 });
    const [good, better] = [phone({ battery: 0.6 }), phone({ battery: 0.9 })];
    const bad = phone({ name: 'Bob', battery: 0.1, rateHz: 1 });
    expect(check(device, bad, good, better)).toEqual([OK, '']);
    expect(checkRow(device, [bad, good, better]).items[2]!.text).toBe('60 % (at least 50 %)');
    expect(check(device, bad, good)).toEqual([
      LOW,
      'Phone: rate 1 Hz (at least 30 Hz), battery 10 % (at least 50 %)',
    ]);
  });

  it('names at most 20 devices', () => {
    const many = Array.from({ length: 30 }, (_, index) => phone({ name: `phone ${index}` }));
    expect(checkRow(required(), many).found).toHaveLength(20);
  });
});
