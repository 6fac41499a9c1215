import type { Seat } from '../game.ts';

/** Shape, colour and letter of a seat: with the name, the four that a player is known by on every screen. */
export interface Identity {
  readonly shape: Shape;
  /** Of the shape, `#rrggbb`. */
  readonly colour: string;
  /** Of a letter or a sentence on that colour, `#rrggbb`; 4.5:1 or more, but 3.2:1 for large letters on coral and green. */
  readonly onColour: { readonly letter: string; readonly sentence: string };
  readonly letter: string;
  /** Above twelve, shapes repeat on a ringed base. */
  readonly isRinged: boolean;
}

export type Shape = (typeof SHAPES)[number]['shape'];

const INK = '#221c14';
const PAPER = '#fff6e4';

/** The art direction of Ubi-Party: `letter` on pieces, `sentence` on a phone that is all in the colour. */
const SHAPES = [
  { shape: 'circle', colour: '#f2543d', letter: PAPER, sentence: INK },
  { shape: 'triangle', colour: '#2c6be0', letter: PAPER, sentence: PAPER },
  { shape: 'square', colour: '#f7b512', letter: INK, sentence: INK },
  { shape: 'star', colour: '#2c9c66', letter: PAPER, sentence: INK },
  { shape: 'diamond', colour: '#f08bb4', letter: INK, sentence: INK },
  { shape: 'cross', colour: '#0e6e78', letter: PAPER, sentence: PAPER },
  { shape: 'hexagon', colour: '#7a3b8f', letter: PAPER, sentence: PAPER },
  { shape: 'drop', colour: '#7cc8f0', letter: INK, sentence: INK },
  { shape: 'ring', colour: '#a9c93a', letter: INK, sentence: INK },
  { shape: 'moon', colour: PAPER, letter: INK, sentence: INK },
  { shape: 'flower', colour: '#8a5a3b', letter: PAPER, sentence: PAPER },
  { shape: 'heart', colour: INK, letter: PAPER, sentence: PAPER },
] as const;

/** Letters, then digits; with shape, colour and ring no two seats look alike. */
const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ234567';

/** The greatest number of players. */
export const MAX_SEATS = LETTERS.length;

export function identityOf(seat: Seat): Identity {
  const { shape, colour, letter, sentence } = SHAPES[seat % SHAPES.length]!;
  return {
    shape,
    colour,
    onColour: { letter, sentence },
    letter: LETTERS[seat]!,
    isRinged: seat >= SHAPES.length,
  };
}
