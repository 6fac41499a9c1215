import type { Mark } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { proposedMark } from './offered-marks.ts';

const CORAL: Mark = { shape: 1, colour: 1, chosen: false };
const BLUE: Mark = { shape: 2, colour: 2, chosen: false };
const taken = [{ name: 'Theo', mark: CORAL }];

describe('the mark that is proposed [EX-100]', () => {
  it('is a free one at first', () => {
    expect(proposedMark(undefined, { free: BLUE, taken })).toEqual(BLUE);
  });

  it('is the one of the last time while it is free', () => {
    const last: Mark = { shape: 5, colour: 6, chosen: false };
    expect(proposedMark(last, { free: BLUE, taken })).toEqual(last);
    expect(proposedMark(CORAL, { free: BLUE, taken })).toEqual(BLUE);
  });

  it('is always the one that the person chose', () => {
    const chosen = { ...CORAL, chosen: true };
    expect(proposedMark(chosen, { free: BLUE, taken })).toEqual(chosen);
  });
});
