import { describe, expect, it } from 'vitest';
import { placeSigns, type NamedToken, type SignStyle } from './place-signs.ts';

const STYLE: SignStyle = { lineHeight: 20, width: 1000, widthOf: (text) => text.length * 10 };
const token = (seat: number, x: number, y: number, name: string): NamedToken => ({
  seat,
  name,
  x,
  y,
  height: 80,
});

/** Four rows as in a lobby. */
const crowd = (count: number): NamedToken[] =>
  Array.from({ length: count }, (_, seat) => {
    const row = Math.floor(seat / 8);
    return token(seat, 100 + (seat % 8) * 84 + (row % 2) * 40, 600 - row * 88, `Player ${seat}`);
  });

describe('names of tokens', () => {
  it('stand below their tokens, in full where there is room', () => {
    expect(placeSigns([token(0, 500, 300, 'Wilhelmine Berg')], STYLE)).toEqual([
      { seat: 0, text: 'Wilhelmine Berg', x: 500, y: 300 },
    ]);
  });

  it('give way to nearer names: the first word, then fewer letters', () => {
    const near = token(0, 500, 300, 'Maximilian');
    const signs = placeSigns([token(1, 440, 299, 'Wilhelmine Berg'), near], STYLE);
    expect(signs.find(({ seat }) => seat === 0)?.text).toBe('Maximilian');
    const second = signs.find(({ seat }) => seat === 1);
    expect('Wilhelmine'.startsWith(second!.text.replace('…', ''))).toBe(true);
  });

  it('keep what tells them apart when others share the first word, or are left out', () => {
    const row = (names: readonly string[]) =>
      placeSigns(
        names.map((name, seat) => token(seat, 100 + seat * 46, 300 - seat, name)),
        STYLE,
      ).map(({ text }) => text);
    const bots = row(['Bot A', 'Bot B', 'Bot C', 'Bot D']);
    expect(bots.length).toBeLessThan(4);
    for (const text of bots) expect(text).toMatch(/^Bot [A-D]$/);
    for (const text of row(['Player 1', 'Player 2', 'Player 3'])) expect(text).toMatch(/ [1-3]$/);
  });

  it('go aside or away where a nearer token stands', () => {
    const signs = placeSigns(
      [token(0, 500, 380, 'Ada'), token(1, 520, 320, 'Bo'), token(2, 500, 318, 'Theodora')],
      STYLE,
    );
    for (const { seat, x, text } of signs) {
      const half = STYLE.widthOf(text) / 2;
      if (seat !== 0) expect(x + half <= 500 - 32 || x - half >= 500 + 32).toBe(true);
    }
  });

  it('stay in the picture', () => {
    const [sign] = placeSigns([token(0, 990, 300, 'Maximilian')], STYLE);
    expect(sign!.x + 50).toBeLessThanOrEqual(1000);
  });

  it.each([2, 4, 8, 12, 18, 32])(
    'of %i players never cover each other or a nearer token',
    (count) => {
      const tokens = crowd(count);
      const signs = placeSigns(tokens, STYLE);
      const boxes = signs.map(({ seat, text, x, y }) => {
        const half = STYLE.widthOf(text) / 2;
        return { seat, left: x - half, right: x + half, top: y, bottom: y + STYLE.lineHeight };
      });
      for (const box of boxes) {
        const others = boxes.filter(({ seat }) => seat !== box.seat);
        const hidden = tokens
          .filter(({ seat, y }) => seat !== box.seat && y > box.top)
          .map(({ x, y }) => ({ left: x - 30, right: x + 30, top: y - 70, bottom: y }));
        for (const other of [...others, ...hidden]) {
          const isApart =
            box.right <= other.left ||
            box.left >= other.right ||
            box.bottom <= other.top ||
            box.top >= other.bottom;
          expect(isApart).toBe(true);
        }
      }
      // The front row always has its names
      const front = signs.filter(({ seat }) => seat < 8).length;
      expect(front).toBe(Math.min(8, count));
    },
  );

  it('stay as they are until they touch, so that they do not flicker', () => {
    const tokens = [token(0, 500, 300, 'Ada'), token(1, 533, 300, 'Bob')];
    const shown = [{ seat: 1, text: 'Bob', x: 533, y: 300 }];
    expect(placeSigns(tokens, STYLE, shown).find(({ seat }) => seat === 1)?.x).toBe(533);
    expect(placeSigns(tokens, STYLE).find(({ seat }) => seat === 1)?.x).not.toBe(533);
  });
});
