import { describe, expect, it } from 'vitest';
import { distinctAt, sortedNames } from './distinct-part.ts';

const names = sortedNames(['hand_left_position', 'hand_right_position', 'clock', 'hand_left_pose']);

describe('distinctAt', () => {
  it('finds where a name differs from the one most like it', () => {
    expect(distinctAt('hand_right_position', names)).toBe('hand_'.length);
    expect(distinctAt('hand_left_position', names)).toBe('hand_left_pos'.length);
  });

  it('is undefined where no other name begins alike', () => {
    expect(distinctAt('tracker', names)).toBeUndefined();
    expect(distinctAt('clock', sortedNames(['clock']))).toBeUndefined();
  });

  it('points into a name that others continue', () => {
    expect(distinctAt('mix', sortedNames(['mix', 'mixer']))).toBe(2);
  });
});
