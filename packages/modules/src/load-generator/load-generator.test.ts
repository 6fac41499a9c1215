import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { loadGenerator } from './load-generator.ts';

describe.each(WAYS)('load-generator %s', (_way, drive) => {
  it.each([
    [0, 0],
    [1, 1],
    [2, 1],
    [10, 55],
    [47, 2_971_215_073],
    // 4 807 526 976 modulo 2^32
    [48, 512_559_680],
  ])('adds up for %d steps', async (iterations, result) => {
    const module = await drive(loadGenerator);
    expect(await module.run(0, { iterations })).toMatchObject({ result, runs: 1 });
  });

  it('computes 1000 steps by default, also for a number that is not finite', async () => {
    const module = await drive(loadGenerator);
    const { result } = await module.run(0, { iterations: 1000 });
    expect((await module.run(16, { iterations: undefined })).result).toBe(result);
    expect((await module.run(16, { iterations: new Sample(NaN, { type: 'double' }) })).result).toBe(
      result,
    );
  });

  it('takes no steps for fewer than none', async () => {
    const module = await drive(loadGenerator);
    expect((await module.run(0, { iterations: -7 })).result).toBe(0);
  });

  it('takes ten million steps for more', async () => {
    const module = await drive(loadGenerator);
    expect((await module.run(0, { iterations: 2 ** 31 - 1 })).result).toBe(2_846_231_355);
  });

  it('counts its runs and says how long each took', async () => {
    const module = await drive(loadGenerator);
    await module.run(0);
    const outputs = await module.run(16);
    expect(outputs).toMatchObject({ runs: 2 });
    expect(outputs.durationMs).toBeGreaterThanOrEqual(0);
  });

  it('gives a stamp back with its time', async () => {
    const module = await drive(loadGenerator);
    const timestamp = { seconds: 1, nanos: 2, millis: 3 };
    expect(await module.run(0)).not.toHaveProperty('echo');
    await module.run(16, { stamp: new Sample(0, { timestamp }) });
    expect(module.outputs.echo).toEqual({ double: 0, timestamp });
  });
});
