import { describe, expect, it } from 'vitest';
import { PhoneDelays } from './phone-delays.ts';

/** Master's measurements of one phone, five seconds apart. */
function measured(...roundTripsMs: readonly number[]): PhoneDelays {
  const delays = new PhoneDelays();
  roundTripsMs.forEach((roundTripMs, index) =>
    delays.record('mara', { roundTripMs, measuredAtMs: index * 5000 }),
  );
  return delays;
}
/** The longest accepted delay between a press and its arrival, milliseconds. */
const mostMs = (...roundTripsMs: readonly number[]): number =>
  measured(...roundTripsMs).of('mara')!.mostMs;

describe('the delay of a phone', () => {
  it('is unknown before the master has measured it', () => {
    expect(new PhoneDelays().of('mara')).toBeUndefined();
    expect(new PhoneDelays().lagOf('mara')).toBeUndefined();
  });

  it('holds half of a round trip, however long that is', () => {
    const { leastMs, mostMs: most } = measured(150, 150, 151, 150).of('mara')!;
    expect(leastMs).toBeLessThan(75);
    expect(leastMs).toBeGreaterThan(65);
    expect(most).toBeGreaterThan(75);
    expect(most).toBeLessThan(85);
  });

  it('dates no press back by a single slow answer', () => {
    expect(measured(300).of('mara')!.leastMs).toBe(0);
    expect(measured(300, 5, 5).of('mara')!.leastMs).toBe(0);
    expect(measured(300, 310, 305).of('mara')!.leastMs).toBe(146);
  });

  it('leaves a few milliseconds on a fast line', () => {
    expect(mostMs(5, 5, 6, 5)).toBeLessThan(2.5 + 6);
  });

  it('holds a packet that is as slow as the lag varies', () => {
    // One way took 75 to 135 ms, the answer always 75 ms
    expect(mostMs(150, 210, 170, 160, 190, 180)).toBeGreaterThanOrEqual(135);
  });

  it('gains little by some slow answers, and by many only what the lag shows', () => {
    expect(mostMs(5, 400, 5, 5, 400, 5, 5)).toBeLessThan(10);
    const delays = measured(5, 400, 400, 400, 5, 400);
    expect(delays.lagOf('mara')).toBe(400);
  });

  it('is never more than games wait for a late press', () => {
    expect(mostMs(3000, 3000)).toBe(400);
  });

  it('goes by the last minute, and takes a measurement once', () => {
    const delays = new PhoneDelays();
    for (let n = 0; n < 20; n += 1) delays.record('mara', { roundTripMs: 300, measuredAtMs: 7 });
    for (let n = 0; n < 3; n += 1)
      delays.record('mara', { roundTripMs: 10, measuredAtMs: 5000 * (n + 1) });
    expect(delays.lagOf('mara')).toBe(10);
    for (let n = 0; n < 3; n += 1)
      delays.record('mara', { roundTripMs: 80, measuredAtMs: 90_000 + n * 5000 });
    expect(delays.of('mara')!.leastMs).toBeGreaterThan(30);
  });

  it('forgets phones that were not measured for minutes, and remembers a bounded number', () => {
    const delays = measured(5);
    for (let n = 0; n < 300; n += 1)
      delays.record(`p${n}`, { roundTripMs: 5, measuredAtMs: 600_001 });
    expect(delays.of('mara')).toBeUndefined();
    expect(delays.of('p299')).toBeUndefined();
    expect(delays.of('p0')).toBeDefined();
  });
});
