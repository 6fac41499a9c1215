/** Shapes of marks, in the order of `MarkShape` from 1 on; people choose among the first ones. [EX-100] */
export const PLAYER_SHAPES = [
  'circle',
  'triangle',
  'square',
  'star',
  'diamond',
  'cross',
  'hexagon',
  'drop',
  'ring',
  'moon',
  'flower',
  'heart',
] as const;

/** Colours of marks, in the order of `MarkColour` from 1 on. Tokens: --player-<colour>. */
export const PLAYER_COLOURS = [
  'coral',
  'blue',
  'yellow',
  'green',
  'pink',
  'petrol',
  'plum',
  'sky',
  'lime',
  'chalk',
  'brown',
  'ink',
] as const;

/** Shapes, and colours, that people choose among. */
export const CHOICES = 8;

export type PlayerShape = (typeof PLAYER_SHAPES)[number];
export type PlayerColour = (typeof PLAYER_COLOURS)[number];

/** A shape and a colour by their numbers, as the master tells them. */
export interface ShapeAndColour {
  readonly shape: number;
  readonly colour: number;
}

/** Display of a client everywhere: shape, colour and letter. */
export interface PlayerIdentity {
  readonly shape: PlayerShape;
  readonly colour: PlayerColour;
  /** First letter or digit of the name, upper case; `?` without one. */
  readonly letter: string;
}

/**
 * The identity of a client by its mark; of one whose master gives no marks by its id, so that it looks the same in every
 * browser.
 */
export function playerIdentity(
  clientId: string,
  name: string,
  mark?: ShapeAndColour,
): PlayerIdentity {
  const place = hash(clientId) % PLAYER_SHAPES.length;
  const letter = /[\p{L}\p{N}]/u.exec(name)?.[0] ?? '?';
  return {
    shape: PLAYER_SHAPES[(mark?.shape ?? 0) - 1] ?? PLAYER_SHAPES[place]!,
    colour: PLAYER_COLOURS[(mark?.colour ?? 0) - 1] ?? PLAYER_COLOURS[place]!,
    letter: letter.toLocaleUpperCase(),
  };
}

/** FNV-1a, 32 bits (Fowler, Noll, Vo; draft-eastlake-fnv): spreads ids that differ in one digit. */
function hash(text: string): number {
  let value = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) {
    value = Math.imul(value ^ text.charCodeAt(i), 0x01000193);
  }
  return value >>> 0;
}
