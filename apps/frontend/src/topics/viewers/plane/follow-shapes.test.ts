import { describe, expect, it } from 'vitest';
import { ShapeTracker } from './follow-shapes.ts';
import type { PlaneShape } from './plane-shapes.ts';

const box = (name: string, x: number, y = 0.2, side = 0.2): PlaneShape => ({
  key: '?',
  name,
  x,
  y,
  size: { width: side, height: side },
});
const letters = (shapes: readonly PlaneShape[]): (string | undefined)[] =>
  shapes.map(({ letter }) => letter);

describe('a tracker of shapes', () => {
  it('gives persons letters that stay while they move and change their order', () => {
    const tracker = new ShapeTracker();
    expect(letters(tracker.follow([box('person', 0.1), box('person', 0.6)], 0))).toEqual([
      'A',
      'B',
    ]);
    const moved = tracker.follow([box('person', 0.55), box('person', 0.15)], 100);
    expect(letters(moved)).toEqual(['B', 'A']);
  });

  it('keeps a letter over a short gap, and gives it to the next one after a long one', () => {
    const tracker = new ShapeTracker();
    tracker.follow([box('person', 0.1)], 0);
    expect(letters(tracker.follow([box('person', 0.7)], 1000)), 'A may come back').toEqual(['B']);
    expect(letters(tracker.follow([box('person', 0.1), box('person', 0.7)], 1500))).toEqual([
      'A',
      'B',
    ]);
    tracker.follow([box('person', 0.7)], 3400);
    expect(letters(tracker.follow([box('person', 0.3, 0.7)], 3600))).toEqual(['A']);
  });

  it('matches the pairs that overlap most, and boxes of the same name only', () => {
    const tracker = new ShapeTracker();
    const [left, right] = tracker.follow([box('cup', 0.1), box('cup', 0.2)], 0);
    const [first, second, other] = tracker.follow(
      [box('cup', 0.19), box('cup', 0.11), box('bowl', 0.1)],
      50,
    );
    expect(first!.key).toBe(right!.key);
    expect(second!.key).toBe(left!.key);
    expect([left!.key, right!.key]).not.toContain(other!.key);
    expect(letters([first!])).toEqual([undefined]);
  });

  it('tells keypoints apart by their names, and those of a second body by their number', () => {
    const point = (name: string): PlaneShape => ({ key: '?', name, x: 0.5, y: 0.5 });
    const keys = new ShapeTracker()
      .follow([point('nose'), point('leftHip'), point('nose')], 0)
      .map(({ key }) => key);
    expect(keys).toEqual(['nose 1', 'leftHip 1', 'nose 2']);
  });

  it('has 26 letters, and remembers a bounded number of boxes', () => {
    const tracker = new ShapeTracker();
    const crowd = Array.from({ length: 300 }, (_, index) =>
      box('person', (index % 20) / 20, Math.floor(index / 20) / 20, 0.01),
    );
    const first = tracker.follow(crowd, 0);
    expect(first.filter(({ letter }) => letter !== undefined)).toHaveLength(26);
    const before = new Set(first.map(({ key }) => key));
    const known = tracker.follow(crowd, 10).filter(({ key }) => before.has(key));
    expect(known).toHaveLength(200);
  });
});
