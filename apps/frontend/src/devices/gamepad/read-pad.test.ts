import { describe, expect, it } from 'vitest';
import { padChanges, readPad, RESTING } from './read-pad.ts';

const pressed = { pressed: true, value: 1 };
const free = { pressed: false, value: 0 };

describe('a gamepad', () => {
  it('says y upwards, and nothing for a stick that nearly rests', () => {
    const { left, right } = readPad({ axes: [0, -1, 0.05, 0.05], buttons: [] });
    expect(left).toEqual({ x: 0, y: 1 });
    expect(right).toEqual({ x: 0, y: 0 });
  });

  it('tells what changed, and that once', () => {
    const source = {
      axes: [1, 0],
      buttons: [pressed, free, free, free, free, free, free, pressed],
    };
    const now = readPad(source);
    const changes = padChanges(RESTING, now);
    expect(changes.left).toEqual({ x: 1, y: 0 });
    expect(changes.right).toBeUndefined();
    expect(changes.rightTrigger).toBe(1);
    expect(changes.buttons).toEqual([{ name: 'button_a', key: '1', isDown: true }]);
    expect(padChanges(now, readPad(source))).toMatchObject({ left: undefined, buttons: [] });
    expect(padChanges(now, RESTING).buttons).toEqual([
      { name: 'button_a', key: '1', isDown: false },
    ]);
  });
});
