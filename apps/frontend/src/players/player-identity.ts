/** Shapes and colours that distinguish clients, in this order. Tokens: --player-<colour>. */
const PLAYERS = [
  { shape: 'circle', colour: 'coral' },
  { shape: 'triangle', colour: 'blue' },
  { shape: 'square', colour: 'yellow' },
  { shape: 'star', colour: 'green' },
  { shape: 'diamond', colour: 'pink' },
  { shape: 'cross', colour: 'petrol' },
  { shape: 'hexagon', colour: 'plum' },
  { shape: 'drop', colour: 'sky' },
  { shape: 'ring', colour: 'lime' },
  { shape: 'moon', colour: 'chalk' },
  { shape: 'flower', colour: 'brown' },
  { shape: 'heart', colour: 'ink' },
] as const;

export type PlayerShape = (typeof PLAYERS)[number]['shape'];
export type PlayerColour = (typeof PLAYERS)[number]['colour'];

/** Display of a client everywhere: shape, colour and letter. */
export interface PlayerIdentity {
  readonly shape: PlayerShape;
  readonly colour: PlayerColour;
  /** First letter or digit of the name, upper case; `?` without one. */
  readonly letter: string;
}

/** Derived from the client's id alone, so that a client looks the same in every browser. */
export function playerIdentity(clientId: string, name: string): PlayerIdentity {
  const player = PLAYERS[hash(clientId) % PLAYERS.length]!;
  const letter = /[\p{L}\p{N}]/u.exec(name)?.[0] ?? '?';
  return { ...player, letter: letter.toLocaleUpperCase() };
}

/** FNV-1a, 32 bits (Fowler, Noll, Vo; draft-eastlake-fnv): spreads ids that differ in one digit. */
function hash(text: string): number {
  let value = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) {
    value = Math.imul(value ^ text.charCodeAt(i), 0x01000193);
  }
  return value >>> 0;
}
