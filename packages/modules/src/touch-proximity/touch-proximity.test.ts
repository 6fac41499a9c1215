import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { touchProximity } from './touch-proximity.ts';

const timestamps = { count: 0 };

/** A touch as a muxer gives it. Each has another time, as if it was published just now. */
function touch(identity: string | undefined, x: number, y: number, finger = 0): Sample {
  const timestamp = { seconds: 0, nanos: 0, millis: ++timestamps.count };
  return new Sample(
    { x, y },
    {
      identity,
      topic: `/${identity}/web-interface-smart-device/touch_position/${finger}`,
      timestamp,
    },
  );
}

/** Whether a finger is on the pad, as a muxer gives it. */
const is = (identity: string, bool: boolean) =>
  new Sample(bool, { identity, topic: `/${identity}/web-interface-smart-device/is_touched` });
const vibrate = (identity: string, double = 100) => ({ double, outputTopicParams: [identity] });
const near = (identity: string, bool = true) => ({ bool, outputTopicParams: [identity] });

describe.each(WAYS)('touch-proximity %s', (_way, drive) => {
  it('publishes nothing for clients while there are no touches', async () => {
    const module = await drive(touchProximity);
    expect(await module.run(0)).toEqual({ vibration: [], isNear: [], nearCount: 0 });
  });

  it('lets two near phones vibrate, and no third one', async () => {
    const module = await drive(touchProximity);
    const touches = [touch('ann', 0.5, 0.5), touch('bob', 0.9, 0.5), touch('cem', 0.55, 0.55)];
    expect(await module.run(0, { touches })).toEqual({
      vibration: [vibrate('ann'), vibrate('cem')],
      isNear: [near('ann'), near('cem')],
      nearCount: 2,
    });
  });

  it('compares distances, not axes', async () => {
    const module = await drive(touchProximity);
    const touches = [touch('ann', 0, 0), touch('bob', 0.09, 0.09)];
    expect(await module.run(0, { touches })).toMatchObject({ nearCount: 0 });
    expect(await module.run(50, { distance: 0.13 })).toMatchObject({ nearCount: 2 });
  });

  it('repeats the vibration when the one before has ended, and the news every half second', async () => {
    const module = await drive(touchProximity);
    const touches = [touch('ann', 0, 0), touch('bob', 0, 0)];
    await module.run(0, { touches, vibrationMs: 80 });
    expect(await module.run(50)).toEqual({ vibration: [], isNear: [], nearCount: 2 });
    expect(await module.run(50)).toMatchObject({
      vibration: [vibrate('ann', 80), vibrate('bob', 80)],
      isNear: [],
    });
    expect(await module.run(399)).toMatchObject({ isNear: [] });
    expect(await module.run(1)).toMatchObject({ isNear: [near('ann'), near('bob')] });
    expect(await module.run(100)).toMatchObject({ isNear: [] });
  });

  it('lets go of a finger that is said to be lifted, in the next run', async () => {
    const module = await drive(touchProximity);
    const touches = [touch('ann', 0, 0), touch('bob', 0, 0)];
    const touching = [is('ann', true), is('bob', true)];
    expect(await module.run(0, { touches, touching })).toMatchObject({ nearCount: 2 });
    expect(await module.run(50, { touching: [is('ann', false), is('bob', true)] })).toMatchObject({
      isNear: [near('bob', false), near('ann', false)],
      nearCount: 0,
    });
    expect(await module.run(50, { touching: [is('ann', true)] })).toMatchObject({ nearCount: 2 });
  });

  it('lets go only beyond the hysteresis', async () => {
    const module = await drive(touchProximity);
    await module.run(0, { hysteresis: 0.05, touches: [touch('ann', 0, 0), touch('bob', 0.1, 0)] });
    const still = [touch('ann', 0, 0), touch('bob', 0.14, 0)];
    expect(await module.run(50, { touches: still })).toMatchObject({ isNear: [], nearCount: 2 });
    const apart = [touch('ann', 0, 0), touch('bob', 0.16, 0)];
    expect(await module.run(50, { touches: apart })).toMatchObject({
      isNear: [near('ann', false), near('bob', false)],
      nearCount: 0,
    });
    expect(await module.run(50, { touches: still })).toMatchObject({ isNear: [], nearCount: 0 });
  });

  it('reports the remaining phone when the other one leaves the list [PM-44]', async () => {
    const module = await drive(touchProximity);
    await module.run(0, { touches: [touch('ann', 0, 0), touch('bob', 0, 0)] });
    expect(await module.run(50, { touches: [touch('ann', 0, 0)] })).toEqual({
      vibration: [],
      isNear: [near('ann', false), near('bob', false)],
      nearCount: 0,
    });
  });

  it('forgets a touch that has not changed for the maximal age', async () => {
    const module = await drive(touchProximity);
    await module.run(0, { maxAgeMs: 100, touches: [touch('ann', 0, 0), touch('bob', 0, 0)] });
    expect(await module.run(100)).toMatchObject({ nearCount: 2 });
    expect(await module.run(1)).toMatchObject({
      isNear: [near('ann', false), near('bob', false)],
    });
    expect(await module.run(100, { maxAgeMs: 0 })).toMatchObject({ nearCount: 2 });
  });

  it('takes fingers of one person as one', async () => {
    const module = await drive(touchProximity);
    const touches = [touch('ann', 0, 0, 1), touch('ann', 0.01, 0, 2), touch('bob', 0.02, 0)];
    expect(await module.run(0, { touches: touches.slice(0, 2) })).toMatchObject({ nearCount: 0 });
    expect(await module.run(50, { touches })).toMatchObject({
      isNear: [near('ann'), near('bob')],
      nearCount: 2,
    });
  });

  it('leaves out elements without identity or position', async () => {
    const module = await drive(touchProximity);
    const touches = [
      touch(undefined, 0, 0),
      touch('', 0, 0),
      touch('ann', NaN, 0),
      touch('bob', 0, 0),
    ];
    expect(await module.run(0, { touches })).toEqual({ vibration: [], isNear: [], nearCount: 0 });
  });

  it('takes names that mean something to the language', async () => {
    const module = await drive(touchProximity);
    const touches = [touch('__proto__', 0, 0), touch('constructor', 0, 0)];
    expect(await module.run(0, { touches })).toMatchObject({
      isNear: [near('__proto__'), near('constructor')],
    });
  });

  it('clamps its parameters and can be told not to vibrate', async () => {
    const module = await drive(touchProximity);
    const touches = [touch('ann', 0, 0), touch('bob', 0, 0)];
    const parameters = { distance: -1, hysteresis: NaN, vibrationMs: -5 };
    expect(await module.run(0, { touches, ...parameters })).toMatchObject({
      vibration: [],
      nearCount: 2,
    });
    expect(await module.run(50, { vibrationMs: 1e9 })).toMatchObject({
      vibration: [vibrate('ann', 10_000), vibrate('bob', 10_000)],
    });
  });
});
