import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { mergeVector2, mergeVector3, mergeVector4 } from './merge-vector.ts';

describe.each(WAYS)('merge-vector %s', (_way, drive) => {
  it('merges two, three and four numbers', async () => {
    const two = await drive(mergeVector2);
    expect(await two.run(0, { x: 1, y: -2 })).toEqual({ vector: { x: 1, y: -2 } });
    const three = await drive(mergeVector3);
    expect(await three.run(0, { x: 1, y: 2, z: 3 })).toEqual({ vector: { x: 1, y: 2, z: 3 } });
    const four = await drive(mergeVector4);
    expect(await four.run(0, { x: 1, y: 2, z: 3, w: 4 })).toEqual({
      vector: { x: 1, y: 2, z: 3, w: 4 },
    });
  });

  it('takes 0 for a part that has no record yet, and says nothing while none has', async () => {
    const module = await drive(mergeVector3);
    expect(await module.run(0)).toEqual({});
    expect(await module.run(10, { y: 0 })).toEqual({ vector: { x: 0, y: 0, z: 0 } });
    expect(await module.run(10, { z: 5 })).toEqual({ vector: { x: 0, y: 0, z: 5 } });
    expect(await module.run(10, { z: undefined })).toEqual({ vector: { x: 0, y: 0, z: 0 } });
  });

  it('publishes nothing while a component is not finite', async () => {
    const module = await drive(mergeVector2);
    expect(await module.run(0, { x: NaN, y: 1 })).toEqual({});
    expect(await module.run(10, { x: Infinity })).toEqual({});
    expect(await module.run(10, { x: 2 })).toEqual({ vector: { x: 2, y: 1 } });
  });

  it('takes any number format [PM-31]', async () => {
    const module = await drive(mergeVector2);
    const x = new Sample(3, { type: 'int32' });
    const y = new Sample(0.5, { type: 'float' });
    expect(await module.run(0, { x, y })).toEqual({ vector: { x: 3, y: 0.5 } });
  });
});
