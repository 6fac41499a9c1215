import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { mirrorPointer } from './mirror-pointer.ts';

describe.each(WAYS)('mirror-pointer %s', (_way, drive) => {
  it('gives the position as it is while no switch is mapped', async () => {
    const module = await drive(mirrorPointer);
    expect(await module.run(0, { pointer: { x: 0.2, y: 0.7 } })).toEqual({
      mirrored: { x: 0.2, y: 0.7 },
    });
  });

  it.each([
    [false, false, { x: 0.25, y: 0.125 }],
    [true, false, { x: 0.75, y: 0.125 }],
    [false, true, { x: 0.25, y: 0.875 }],
    [true, true, { x: 0.75, y: 0.875 }],
  ])('mirrors x %s and y %s', async (mirrorX, mirrorY, mirrored) => {
    const module = await drive(mirrorPointer);
    const outputs = await module.run(0, { pointer: { x: 0.25, y: 0.125 }, mirrorX, mirrorY });
    expect(outputs).toEqual({ mirrored });
  });

  it('puts out 0 and mirrors what is outside to the other outside', async () => {
    const module = await drive(mirrorPointer);
    const outputs = await module.run(0, {
      pointer: { x: 1, y: 1.5 },
      mirrorX: true,
      mirrorY: true,
    });
    expect(outputs).toEqual({ mirrored: { x: 0, y: -0.5 } });
  });

  it('says nothing without a pointer, nor for one that is nowhere', async () => {
    const module = await drive(mirrorPointer);
    expect(await module.run(0, { mirrorX: true })).toEqual({});
    expect(await module.run(16, { pointer: { x: NaN, y: 0 } })).toEqual({});
    expect(await module.run(16, { pointer: { x: 0, y: Infinity } })).toEqual({});
    expect(await module.run(16, { pointer: { x: 0, y: 0 } })).toEqual({ mirrored: { x: 1, y: 0 } });
  });

  it('keeps the moment of the pointer, but not when only a switch changed [PM-12] [PM-32]', async () => {
    const module = await drive(mirrorPointer);
    const timestamp = { seconds: 1, nanos: 2, millis: 3 };
    const pointer = new Sample({ x: 0, y: 0 }, { timestamp });
    await module.run(0, { pointer }, ['pointer']);
    expect(module.outputs).toMatchObject({ mirrored: { timestamp } });
    await module.run(16, { mirrorY: true }, ['mirrorY']);
    expect(module.outputs).toEqual({ mirrored: { vector2: { x: 0, y: 1 } } });
  });
});
