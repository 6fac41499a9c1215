import { TouchEventType as TouchType } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { Fingers } from './fingers.ts';

const at = (x: number, y = 0.5) => ({ x, y });

describe('fingers on a pad', () => {
  it('start, move and end under one number', () => {
    const fingers = new Fingers();
    expect(fingers.start(77, at(0.1), 0.4)).toEqual({
      type: TouchType.TOUCH_START,
      position: at(0.1),
      id: '1',
      force: 0.4,
    });
    fingers.move(77, at(0.2), 0.5);
    fingers.move(77, at(0.3), 0.6);
    expect(fingers.takeMoves()).toEqual([
      { type: TouchType.TOUCH_MOVE, position: at(0.3), id: '1', force: 0.6 },
    ]);
    expect(fingers.takeMoves()).toEqual([]);
    expect(fingers.end(77)).toMatchObject({
      type: TouchType.TOUCH_END,
      position: at(0.3),
      id: '1',
    });
    expect(fingers.all).toEqual([]);
  });

  it('are distinguished, and a number is given again when its finger has gone', () => {
    const fingers = new Fingers();
    fingers.start(5, at(0.1), 0);
    expect(fingers.start(6, at(0.2), 0).id).toBe('2');
    expect(fingers.first?.number).toBe(1);
    fingers.end(5);
    expect(fingers.first?.number).toBe(2);
    expect(fingers.start(7, at(0.3), 0).id).toBe('1');
  });

  it('leave a trail of bounded length', () => {
    const fingers = new Fingers();
    fingers.start(1, at(0), 0);
    for (let i = 1; i <= 1000; i++) fingers.move(1, at(i / 1000), 0);
    expect(fingers.first?.trail).toHaveLength(24);
    expect(fingers.first?.trail.at(-1)).toEqual(at(1));
  });

  it('that never came down do nothing', () => {
    const fingers = new Fingers();
    fingers.move(9, at(0.5), 0);
    expect(fingers.end(9)).toBeUndefined();
    expect(fingers.takeMoves()).toEqual([]);
  });
});
