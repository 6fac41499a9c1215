import { describe, expect, it } from 'vitest';
import { placeLabels, type Area, type LabelSpot, type LabelWish } from './place-labels.ts';

const VIEW: Area = { x: 0, y: 0, width: 400, height: 300 };
const wish = (key: string, x: number, y: number, side = 100): LabelWish => ({
  key,
  box: { x, y, width: side, height: side },
  width: 60,
  height: 20,
});
const spots = (wishes: readonly LabelWish[], before?: ReadonlyMap<string, LabelSpot>): string[] =>
  placeLabels(wishes, VIEW, 4, before).map(({ spot }) => spot);

describe('labels', () => {
  it('stand outside at the top left, and keep a gap', () => {
    expect(placeLabels([wish('a', 50, 80)], VIEW, 4)).toEqual([
      { key: 'a', spot: 'above left', x: 50, y: 56, width: 60, height: 20 },
    ]);
  });

  it('stand inside at the bottom where another one is in the way', () => {
    expect(spots([wish('a', 50, 80), wish('b', 70, 84)])).toEqual([
      'above left',
      'inside bottom left',
    ]);
  });

  it('stand inside where there is no room above, and are moved in from the sides', () => {
    expect(spots([wish('a', 50, 4)])).toEqual(['inside bottom left']);
    const [right, left] = placeLabels([wish('b', 380, 80), wish('c', -30, 200)], VIEW, 4);
    expect(right).toMatchObject({ spot: 'above left', x: 340 });
    expect(left).toMatchObject({ spot: 'above left', x: 0 });
  });

  it('never cover each other while there is a spot for each', () => {
    const same = Array.from({ length: 4 }, (_, index) => wish(`${index}`, 100, 100));
    const placed = placeLabels(same, VIEW, 4);
    for (const [index, a] of placed.entries()) {
      for (const b of placed.slice(index + 1)) {
        const isApart =
          a.x + a.width <= b.x ||
          b.x + b.width <= a.x ||
          a.y + a.height <= b.y ||
          b.y + b.height <= a.y;
        expect(isApart, `${a.spot} and ${b.spot}`).toBe(true);
      }
    }
  });

  it('are all placed when there are too many for one box', () => {
    const many = Array.from({ length: 20 }, (_, index) => wish(`${index}`, 100, 100, 20));
    expect(placeLabels(many, VIEW, 4)).toHaveLength(20);
  });

  it('stay where they are until that spot is taken, and need room to spare to leave for another', () => {
    // 2 pixels are free between the two labels: enough to stay, too little to move there.
    const near = [wish('a', 50, 80), wish('b', 112, 80)];
    expect(spots(near)[1]).toBe('inside bottom left');
    expect(spots(near, new Map([['b', 'above left']]))[1]).toBe('above left');
    const over = [wish('a', 50, 80), wish('b', 105, 80)];
    expect(spots(over, new Map([['b', 'above left']]))[1]).toBe('inside bottom left');
  });
});
