import { describe, expect, it } from 'vitest';
import { SharedParts } from './shared-parts.ts';

describe('SharedParts', () => {
  it('starts each once and ends the last one first, also when one cannot start', async () => {
    const parts = new SharedParts();
    const ended: string[] = [];
    const part = (name: string) => async () => ({ stop: async () => void ended.push(name) });
    const first = await parts.get('a', part('a'));
    await parts.get('b', part('b'));
    expect(await parts.get('a', part('c'))).toBe(first);
    const failing = parts.get('d', () => Promise.reject(new Error('no')));
    await expect(failing).rejects.toThrow('no');
    await parts.stop();
    expect(ended).toEqual(['b', 'a']);
  });
});
