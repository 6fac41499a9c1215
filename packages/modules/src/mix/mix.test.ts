import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { mix } from './mix.ts';

describe.each(WAYS)('mix %s', (_way, drive) => {
  it('adds what is there and counts a missing input as 0', async () => {
    const module = await drive(mix);
    expect(await module.run(0)).toEqual({});
    expect(await module.run(0, { b: 2 })).toEqual({ mixed: 2 });
    expect(await module.run(0, { a: 1, c: 0.5 })).toEqual({ mixed: 3.5 });
  });

  it('multiplies each input by its gain', async () => {
    const module = await drive(mix);
    expect(await module.run(0, { a: 10, b: 4, gainA: 0.5, gainB: -1 })).toEqual({ mixed: 1 });
  });

  it('takes the default for a gain that is not a number', async () => {
    const module = await drive(mix);
    expect(await module.run(0, { a: 3, gainA: NaN, b: NaN })).toEqual({ mixed: 3 });
  });

  it('puts out nothing when the sum is not finite', async () => {
    const module = await drive(mix);
    expect(await module.run(0, { a: 1e308, b: 1e308 })).toEqual({});
  });

  it('takes any number format [PM-31]', async () => {
    const module = await drive(mix);
    const inputs = { a: new Sample(2, { type: 'int32' }), b: new Sample(0.5, { type: 'float' }) };
    expect(await module.run(0, inputs)).toEqual({ mixed: 2.5 });
  });
});
