import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { averagePositions } from './average-positions.ts';

const at = (identity: string | undefined, x: number, y: number) =>
  new Sample({ x, y }, { identity, topic: `/${identity}/position` });
const offset = (identity: string, x: number, y: number) => ({
  vector2: { x, y },
  outputTopicParams: [identity],
});

describe.each(WAYS)('average-positions %s', (_way, drive) => {
  it('gives the middle, and each offset back to its identity', async () => {
    const module = await drive(averagePositions);
    const positions = [at('ann', 0, 0), at('bob', 1, 0.5)];
    expect(await module.run(0, { positions })).toEqual({
      middle: { x: 0.5, y: 0.25 },
      count: 2,
      offsets: [offset('ann', -0.5, -0.25), offset('bob', 0.5, 0.25)],
    });
  });

  it('follows those that come and go', async () => {
    const module = await drive(averagePositions);
    expect(await module.run(0)).toEqual({ count: 0 });
    await module.run(33, { positions: [at('ann', 0, 0), at('bob', 1, 1)] });
    expect(await module.run(33, { positions: [at('bob', 1, 1)] })).toMatchObject({
      middle: { x: 1, y: 1 },
      count: 1,
    });
  });

  it('counts a position without identity, and has no offset for it', async () => {
    const module = await drive(averagePositions);
    expect(await module.run(0, { positions: [at(undefined, 0.5, 0.5)] })).toEqual({
      middle: { x: 0.5, y: 0.5 },
      count: 1,
      offsets: [],
    });
  });

  it('leaves out what is not a position', async () => {
    const module = await drive(averagePositions);
    const positions = [at('ann', NaN, 0), at('bob', 0.5, 0.5), at('cem', Infinity, 0)];
    expect(await module.run(0, { positions })).toMatchObject({ count: 1 });
  });
});
