import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { threshold } from './threshold.ts';

const ROSE = { isAbove: true, rose: true };
const FELL = { isAbove: false, fell: true };

describe.each(WAYS)('threshold %s', (_way, drive) => {
  it('says once where the first value is, which is no event', async () => {
    const low = await drive(threshold);
    expect(await low.run(0, { value: 0 })).toEqual({ isAbove: false });
    expect(await low.run(10)).toEqual({});
    const high = await drive(threshold);
    expect(await high.run(0, { value: 1 })).toEqual({ isAbove: true });
  });

  it('tells each edge once and counts the rising ones', async () => {
    const module = await drive(threshold);
    await module.run(0, { value: 0, threshold: 10 });
    expect(await module.run(10, { value: 10 })).toEqual({ ...ROSE, riseCount: 1 });
    expect(await module.run(10, { value: 11 })).toEqual({});
    expect(await module.run(10, { value: 9.999 })).toEqual(FELL);
    expect(await module.run(10, { value: 20 })).toEqual({ ...ROSE, riseCount: 2 });
  });

  it('falls only below the hysteresis', async () => {
    const module = await drive(threshold);
    await module.run(0, { value: 0, threshold: 1, hysteresis: 0.25 });
    await module.run(10, { value: 1 });
    expect(await module.run(10, { value: 0.8 })).toEqual({});
    expect(await module.run(10, { value: 0.75 })).toEqual({});
    expect(await module.run(10, { value: 0.7 })).toEqual(FELL);
    expect(await module.run(10, { value: 0.9 })).toEqual({});
  });

  it('clamps a negative hysteresis to 0, and uses the default for parameters that are not finite', async () => {
    const module = await drive(threshold);
    await module.run(0, { value: 0, threshold: NaN, hysteresis: -5 });
    expect(await module.run(10, { value: 0.5 })).toMatchObject(ROSE);
    expect(await module.run(10, { value: 0.49 })).toEqual(FELL);
  });

  it('leaves NaN out and knows where infinity is', async () => {
    const module = await drive(threshold);
    expect(await module.run(0, { value: NaN })).toEqual({});
    expect(await module.run(10, { value: -Infinity })).toEqual({ isAbove: false });
    expect(await module.run(10, { value: NaN })).toEqual({});
    expect(await module.run(10, { value: Infinity })).toMatchObject(ROSE);
  });

  it('goes by a threshold that moves under a value that rests', async () => {
    const module = await drive(threshold);
    await module.run(0, { value: 0.6 });
    expect(await module.run(10, { threshold: 0.7 }, ['threshold'])).toEqual(FELL);
    expect(await module.run(10, { threshold: 0.6 }, ['threshold'])).toMatchObject(ROSE);
  });

  it('takes any number format [PM-31]', async () => {
    const module = await drive(threshold);
    expect(await module.run(0, { value: new Sample(3, { type: 'int32' }) })).toEqual({
      isAbove: true,
    });
    expect(await module.run(10, { value: new Sample(0.25, { type: 'float' }) })).toEqual(FELL);
  });

  it('keeps its instances apart', async () => {
    const one = await drive(threshold);
    await one.run(0, { value: 1 });
    const other = await drive(threshold);
    expect(await other.run(0, { value: 0 })).toEqual({ isAbove: false });
  });
});
