import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { counter } from './counter.ts';

describe.each(WAYS)('counter %s', (_way, drive) => {
  it('counts each true that triggers it', async () => {
    const module = await drive(counter);
    expect(await module.run(0, { event: false }, ['event'])).toEqual({ count: 0 });
    expect(await module.run(10, { event: true }, ['event'])).toEqual({ count: 1 });
    expect(await module.run(10, { event: true }, ['event'])).toEqual({ count: 2 });
    expect(await module.run(10, { event: false }, ['event'])).toEqual({});
  });

  it('counts changes from false to true in other modes', async () => {
    const module = await drive(counter);
    await module.run(0, { event: false });
    expect(await module.run(10, { event: true })).toEqual({ count: 1 });
    expect(await module.run(10)).toEqual({});
    await module.run(10, { event: false });
    expect(await module.run(10, { event: true })).toEqual({ count: 2 });
  });

  it('starts again at zero after a reset', async () => {
    const module = await drive(counter);
    await module.run(0, { event: true }, ['event']);
    expect(await module.run(10, { reset: true }, ['reset'])).toEqual({ count: 0 });
    expect(await module.run(10, { reset: false }, ['reset'])).toEqual({});
    expect(await module.run(10, { event: true }, ['event'])).toEqual({ count: 1 });
  });

  it('counts in steps, down too', async () => {
    const module = await drive(counter);
    await module.run(0, { event: true, step: -5 }, ['event']);
    expect(await module.run(10, { event: true }, ['event'])).toEqual({ count: -10 });
  });
});
