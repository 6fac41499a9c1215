import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { keyChord } from './key-chord.ts';

const down = (key: string) => ({ key: { type: 1, key } });
const up = (key: string) => ({ key: { type: 0, key } });

describe.each(WAYS)('key-chord %s', (_way, drive) => {
  it('names the keys that are held, in the order in which they went down', async () => {
    const module = await drive(keyChord);
    expect(await module.run(0)).toEqual({});
    expect(await module.run(0, down('d'))).toEqual({ chord: 'd', count: 1 });
    expect(await module.run(0, down('a'))).toEqual({ chord: 'd + a', count: 2 });
    expect(await module.run(0, up('d'))).toEqual({ chord: 'a', count: 1 });
    expect(await module.run(0, up('a'))).toEqual({ chord: '', count: 0 });
  });

  it('ignores the repetition of a held key', async () => {
    const module = await drive(keyChord);
    await module.run(0, down('a'));
    expect(await module.run(0, down('a'))).toEqual({});
  });

  it('writes the name of the space bar', async () => {
    const module = await drive(keyChord);
    expect(await module.run(0, down(' '))).toEqual({ chord: 'Space', count: 1 });
  });

  it('holds 16 keys at most', async () => {
    const module = await drive(keyChord);
    for (let key = 0; key < 40; key += 1) await module.run(0, down(`key ${key}`));
    expect(await module.run(0, up('key 3'))).toMatchObject({ count: 15 });
  });
});
