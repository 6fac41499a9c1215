import { describe, expect, it } from 'vitest';
import { stepsLeft } from './next-steps.ts';

const opened = (...ids: string[]) => ids.map((id) => ({ id }));

describe('stepsLeft()', () => {
  it('offers the other steps to who has changed the first session', () => {
    expect(stepsLeft(opened('session 3f2a', 'page /topics'))).toEqual(['phone', 'example']);
  });

  it('offers the other steps to who has started an example', () => {
    expect(stepsLeft(opened('example party'))).toEqual(['phone', 'module']);
  });

  it('leaves out what was done or dismissed', () => {
    expect(stepsLeft(opened('session 3f2a', 'step phone'))).toEqual(['example']);
    expect(stepsLeft(opened('session 3f2a', 'step phone', 'step example'))).toEqual([]);
  });

  it('offers none to who has opened several things', () => {
    const ids = ['a', 'b', 'c', 'd'].map((name) => `session ${name}`);
    expect(stepsLeft(opened(...ids))).toEqual([]);
  });
});
