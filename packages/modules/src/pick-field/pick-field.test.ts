import { describe, expect, it } from 'vitest';
import { Sample } from '../../test/drive-module.ts';
import { WAYS } from '../../test/ways.ts';
import { pickField } from './pick-field.ts';

const POSE = { position: { x: 1, y: 2, z: 3 }, quaternion: { x: 0, y: 0, z: 0, w: 1 } };

describe.each(WAYS)('pick-field %s', (_way, drive) => {
  it('picks a number, a vector and a rotation out of a pose', async () => {
    const module = await drive(pickField);
    expect(await module.run(0, { value: POSE, path: 'position.y' })).toEqual({
      number: 2,
      text: '2',
    });
    expect(await module.run(10, { path: 'position' })).toEqual({
      vector2: { x: 1, y: 2 },
      vector3: { x: 1, y: 2, z: 3 },
    });
    expect(await module.run(10, { path: 'quaternion' })).toMatchObject({
      quaternion: { x: 0, y: 0, z: 0, w: 1 },
      vector4: { x: 0, y: 0, z: 0, w: 1 },
    });
  });

  it('picks out of any format [PM-3]', async () => {
    const module = await drive(pickField);
    const key = new Sample({ type: 1, key: 'a' }, { type: 'keyEvent' });
    expect(await module.run(0, { value: key, path: 'key' })).toEqual({ text: 'a' });
    const list = new Sample({ elements: [4, 5] }, { type: 'doubleList' });
    expect(await module.run(10, { value: list, path: 'elements[1]' })).toMatchObject({ number: 5 });
    const truth = new Sample(true, { type: 'bool' });
    expect(await module.run(10, { value: truth, path: '' })).toEqual({
      isTrue: true,
      number: 1,
      text: 'true',
    });
    const color = new Sample({ r: 1, g: 0, b: 0.5, a: 1 }, { type: 'color' });
    expect(await module.run(10, { value: color, path: '$' })).toEqual({
      color: { r: 1, g: 0, b: 0.5, a: 1 },
    });
  });

  it('publishes an error once, and once its end', async () => {
    const module = await drive(pickField);
    const error = 'The value has no "position.up": "up" is missing.';
    expect(await module.run(0, { value: POSE, path: 'position.up' })).toEqual({ error });
    expect(await module.run(10, { value: POSE })).toEqual({});
    expect(await module.run(10, { path: 'position.x' })).toMatchObject({ number: 1, error: '' });
  });

  it('does not look where the value has nothing of its own', async () => {
    const module = await drive(pickField);
    const { error } = await module.run(0, { value: POSE, path: 'constructor.name' });
    expect(error).toBe('The value has no "constructor.name": "constructor" is missing.');
  });
});
