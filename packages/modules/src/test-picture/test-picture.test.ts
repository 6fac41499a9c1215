import type { Image2D } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { testPicture } from './test-picture.ts';

describe.each(WAYS)('test-picture %s', (_way, drive) => {
  it('gives a complete picture of the chosen size', async () => {
    const module = await drive(testPicture);
    const picture = (await module.run(0, { width: 32, height: 20 })).picture as Image2D;
    expect(picture).toMatchObject({ width: 32, height: 20, dataFormat: 1 });
    expect(picture.data).toHaveLength(32 * 20 * 3);
    expect(new Set(picture.data).size).toBeGreaterThan(5);
  });

  it('keeps the size within its range', async () => {
    const module = await drive(testPicture);
    const { picture } = await module.run(0, { width: 1, height: -5 });
    expect(picture).toMatchObject({ width: 16, height: 16 });
  });

  it('moves with time alone', async () => {
    const module = await drive(testPicture);
    const size = { width: 32, height: 20 };
    const first = (await module.run(0, size)).picture as Image2D;
    const same = (await module.run(0)).picture as Image2D;
    const later = (await module.run(500)).picture as Image2D;
    expect([...same.data]).toEqual([...first.data]);
    expect([...later.data]).not.toEqual([...first.data]);
  });
});
